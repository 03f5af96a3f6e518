//! The voxel array: a box of labels with its module size and origin.

use super::Label;

/// Edge lengths of one voxel in metres, x, y, z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Module {
    /// Metres along x, y and z, all positive.
    pub size_m: [f64; 3],
}

impl Default for Module {
    /// 0.900 x 0.900 x 0.540 m: three stair steps of 300 x 180 mm; six modules make a storey of 3.24 m.
    fn default() -> Self {
        Module { size_m: [0.9, 0.9, 0.54] }
    }
}

/// Modules in one storey: one slab layer and five layers of room.
pub const STOREY_MODULES: usize = 6;

/// A box of labels, x fastest: index `x + nx (y + ny z)`.
///
/// Everything outside the box is empty. Layer k = 0 is the foundation layer; ground level is the centre of its voxels.
#[derive(Clone, Debug, PartialEq)]
pub struct VoxelArray {
    shape: [usize; 3],
    labels: Vec<Label>,
    /// Size of one voxel.
    pub module: Module,
    /// Centre of voxel (0, 0, 0) in metres (topoGenesis calls it `minbound`).
    pub origin_m: [f64; 3],
}

impl VoxelArray {
    /// An empty array of `shape` voxels with the default module, voxel (0,0,0) centred at the origin.
    pub fn new(shape: [usize; 3]) -> Self {
        VoxelArray {
            shape,
            labels: vec![Label::Empty; shape[0] * shape[1] * shape[2]],
            module: Module::default(),
            origin_m: [0.0; 3],
        }
    }

    /// An array from labels in x-fastest order; `None` when their number is not nx ny nz.
    pub fn from_labels(shape: [usize; 3], labels: Vec<Label>) -> Option<Self> {
        (labels.len() == shape[0] * shape[1] * shape[2])
            .then(|| VoxelArray { labels, ..VoxelArray::new([0; 3]) }.with_shape(shape))
    }

    fn with_shape(mut self, shape: [usize; 3]) -> Self {
        self.shape = shape;
        self
    }

    /// Voxels along x, y and z.
    #[inline]
    pub fn shape(&self) -> [usize; 3] {
        self.shape
    }

    /// All labels, x fastest, then y, then z.
    #[inline]
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    /// Position of a voxel in [`VoxelArray::labels`].
    #[inline]
    pub fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        x + self.shape[0] * (y + self.shape[1] * z)
    }

    /// The label of a voxel inside the box.
    #[inline]
    pub fn get(&self, voxel: [usize; 3]) -> Label {
        self.labels[self.index(voxel)]
    }

    /// The label at any integer position: empty outside the box.
    #[inline]
    pub fn at(&self, [x, y, z]: [isize; 3]) -> Label {
        let [nx, ny, nz] = self.shape;
        if x < 0 || y < 0 || z < 0 || x as usize >= nx || y as usize >= ny || z as usize >= nz {
            Label::Empty
        } else {
            self.get([x as usize, y as usize, z as usize])
        }
    }

    /// Sets the label of a voxel inside the box.
    #[inline]
    pub fn set(&mut self, voxel: [usize; 3], label: Label) {
        let index = self.index(voxel);
        self.labels[index] = label;
    }

    /// Every voxel with its label, in storage order.
    pub fn iter(&self) -> impl Iterator<Item = ([usize; 3], Label)> + '_ {
        let [nx, ny, _] = self.shape;
        self.labels
            .iter()
            .enumerate()
            .map(move |(i, &label)| ([i % nx.max(1), i / nx.max(1) % ny.max(1), i / (nx * ny).max(1)], label))
    }

    /// Number of voxels that are not empty.
    pub fn filled_count(&self) -> usize {
        self.labels.iter().filter(|l| l.is_filled()).count()
    }
}
