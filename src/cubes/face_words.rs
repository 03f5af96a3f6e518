//! Face numbers of 61 cubes at once: the rule of [`super::face_number`] in words of bits, one bit a voxel.

use super::layers::Planes;

/// How the columns of a row stand to a roof in the same layer: bits where a column goes on with it, or is full.
#[derive(Clone, Copy)]
struct Row {
    /// A roof at the same level.
    level: u64,
    /// A roof one voxel higher.
    up: u64,
    /// A roof one voxel lower.
    down: u64,
    /// Filled in this layer and in the one above, `up` included.
    full: u64,
}

impl Row {
    /// From the layer below the roofs, theirs, and two above.
    #[inline]
    fn new([below, own, above, top]: [Planes; 4]) -> Row {
        let [filled, over] = [own.filled(), above.filled()];
        Row {
            level: own.no_slab() & !over,
            up: filled & above.no_slab() & !top.filled(),
            down: below.no_slab() & !filled & !over,
            full: filled & over,
        }
    }

    /// The columns one further along x, or one back.
    #[inline]
    fn shifted(self, along: Along) -> Row {
        let shift = |word: u64| match along {
            Along::Next => word >> 1,
            Along::Same => word,
            Along::Last => word << 1,
        };
        Row { level: shift(self.level), up: shift(self.up), down: shift(self.down), full: shift(self.full) }
    }

    /// Where the roof goes on.
    #[inline]
    fn known(self) -> u64 {
        self.level | self.up | self.down
    }

    /// At which height; 0 where nothing is known.
    #[inline]
    fn height(self) -> Height {
        Height { some: self.level | self.up, two: self.up }
    }
}

#[derive(Clone, Copy)]
enum Along {
    Last,
    Same,
    Next,
}

/// Heights 0, 1 and 2 in half modules, a bit in two words each: at least 1, and 2.
#[derive(Clone, Copy)]
struct Height {
    some: u64,
    two: u64,
}

impl Height {
    /// 2 less the height.
    #[inline]
    fn across(self) -> Height {
        Height { some: !self.two, two: !self.some }
    }

    #[inline]
    fn min(self, other: Height) -> Height {
        Height { some: self.some & other.some, two: self.two & other.two }
    }

    /// This where `when` has a bit, else the other.
    #[inline]
    fn or(self, when: u64, other: Height) -> Height {
        let pick = |a: u64, b: u64| a & when | b & !when;
        Height { some: pick(self.some, other.some), two: pick(self.two, other.two) }
    }

    /// The lower of both where `when` has a bit, else this.
    #[inline]
    fn min_where(self, when: u64, other: Height) -> Height {
        self.min(Height { some: other.some | !when, two: other.two | !when })
    }

    /// A lean-to between what stands ahead and behind.
    #[inline]
    fn lean_to(ahead: Row, behind: Row) -> Height {
        Height { some: ahead.full | !behind.full, two: ahead.full & !behind.full }
    }
}

/// The codes of the numbers that roofs have on their faces towards one direction, as planes of bits; 0 where there is no roof. `at`
/// holds the columns around them: behind, beside and ahead of the roofs, each left of, in and right of their line.
#[inline]
fn numbers(at: [[Row; 3]; 3]) -> [u64; 3] {
    let [behind, beside, ahead] = at;
    let roofs = beside[1].level;
    let ends = roofs & !ahead[1].known();
    let wall = ahead[1].full;
    let (straight, is_straight) = (behind[1].height().across(), behind[1].known());
    let sides = [0, 2].map(|s| {
        let (roof, on) = (beside[s].level, ahead[s].known());
        let slope = ahead[s].height().or(on, behind[s].height().across());
        (roof, roof & on, roof & (on | behind[s].known()), slope)
    });
    let [(_, on_left, slopes_left, left), (_, on_right, slopes_right, right)] = sides;
    let past = wall & on_left & on_right;
    let lean = left.min(right).or(slopes_left & slopes_right, Height::lean_to(ahead[1], behind[1]));
    let mut height = ahead[0].height().min(ahead[2].height()).or(past, straight.or(is_straight, lean));
    for (n, s) in [0, 2].into_iter().enumerate() {
        let (roof, _, slopes, slope) = sides[n];
        let edge = roof & !wall & !ahead[s].level;
        height = height.min_where(edge & slopes, slope);
        let follows = edge & !slopes & !(is_straight & sides[1 - n].2);
        height = height.min_where(follows, Height::lean_to(ahead[s], behind[s]));
        let valley = roof & !wall & ahead[s].level & behind[s].up;
        height = height.min_where(valley, Height { some: 0, two: 0 });
    }
    let (down, up) = (roofs & ahead[1].down, roofs & ahead[1].up);
    let Height { some, two } = height;
    // StepDown 1, StepUp 2, End0 3, End1 4, End2 5.
    [down | ends & (!some | two), up | ends & !some, ends & some]
}

/// Number codes of a stride's faces as planes of bits: bit i is cube i.
#[derive(Clone, Copy, Default)]
pub(super) struct FaceWords {
    /// Faces across x: bit i the west face of cube i, bit i + 1 its east face.
    across: [u64; 3],
    /// South faces, then north faces.
    along: [[u64; 3]; 2],
}

impl FaceWords {
    /// From the rows and layers around a stride of cubes, `layers[z][row]`, lowest first.
    pub fn new(layers: [[Planes; 4]; 4]) -> FaceWords {
        let rows = [0, 1, 2, 3].map(|r| Row::new(layers.map(|layer| layer[r])));
        let in_x = |r: usize, turned: bool| {
            let line = |along: Along| [r - 1, r, r + 1].map(|n| rows[n].shifted(along));
            let [last, same, next] = [Along::Last, Along::Same, Along::Next].map(line);
            numbers(if turned { [next, same, last] } else { [last, same, next] })
        };
        let in_y = |order: [usize; 3]| {
            numbers(order.map(|r| [Along::Last, Along::Same, Along::Next].map(|along| rows[r].shifted(along))))
        };
        let (east, west) = ([in_x(1, false), in_x(2, false)], [in_x(1, true), in_x(2, true)]);
        let (north, south) = (in_y([0, 1, 2]), in_y([3, 2, 1]));
        // Of the two roofs at a face at most one has a number on it. Cube i lies between bits i + 1 and i + 2.
        FaceWords {
            across: [0, 1, 2].map(|p| (north[p] | south[p]) >> 1),
            along: [0, 1].map(|n| [0, 1, 2].map(|p| east[n][p] >> 1 | west[n][p] >> 2)),
        }
    }

    /// Cubes with a number on some face.
    #[inline]
    pub fn any(&self) -> u64 {
        let across = self.across[0] | self.across[1] | self.across[2];
        self.along.as_flattened().iter().fold(across | across >> 1, |all, plane| all | plane)
    }

    /// Bits where a cube's numbers differ from those of the cube before it.
    #[inline]
    pub fn changes(&self) -> u64 {
        let across = self.across.iter().fold(0, |all, plane| all | (plane ^ plane << 1));
        self.along.as_flattened().iter().fold(across | across >> 1, |all, plane| all | (plane ^ plane << 1))
    }

    /// The four codes of cube i, 3 bits each, in the order of `Direction::ALL`: east, north, west, south.
    #[inline]
    pub fn codes(&self, i: u32) -> u64 {
        (0..3).fold(0, |codes, p| {
            let across = self.across[p] >> i;
            let [south, north] = self.along.map(|planes| planes[p] >> i & 1);
            codes | (across >> 1 & 1 | north << 3 | (across & 1) << 6 | south << 9) << p
        })
    }
}
