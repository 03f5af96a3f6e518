//! Reading and writing the OBJ subset of tiles: vertices, groups, materials, polygons, lines. Every element keeps its line number,
//! which a general OBJ reader does not give and without which a designer cannot find a mistake; every mistake is kept, not the first.

use super::TilesetError;
use super::axes::Axes;
use std::fmt::Write;
use std::path::Path;

/// A polygon or a polyline with its group and line numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Element {
    /// Group (or object) it belongs to.
    pub group: String,
    /// Material (`usemtl`) it has.
    pub material: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Vertices in the cube, in the unit of the [`Grid`].
    pub points: Vec<[i32; 3]>,
    /// Line of each vertex.
    pub point_lines: Vec<usize>,
    /// Polygon (`f`) or line (`l`).
    pub is_polygon: bool,
}

/// What coordinates are rounded to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Grid {
    /// Whole millimetres; anything between is a mistake.
    Millimetre,
    /// Whole micrometres, the nearest.
    Micrometre,
}

/// What an OBJ text holds.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// Polygons and lines whose vertices are known.
    pub elements: Vec<Element>,
    /// Lines that cannot be understood, in their order.
    pub mistakes: Vec<TilesetError>,
    /// Lowest and highest corner of all vertices in the cube, mm.
    pub bounds_mm: Option<[[f64; 3]; 2]>,
}

struct Reader<'a> {
    path: &'a Path,
    axes: &'a Axes,
    grid: Grid,
    line: usize,
    group: String,
    material: String,
    /// `None` for a vertex that is no number: it keeps its place in the count.
    vertices: Vec<Option<([i32; 3], usize)>>,
    drawing: Drawing,
}

/// Reads an OBJ text into the cube.
pub(super) fn read_obj(text: &str, path: &Path, axes: &Axes, grid: Grid) -> Drawing {
    let mut reader = Reader {
        path,
        axes,
        grid,
        line: 0,
        group: String::new(),
        material: String::new(),
        vertices: Vec::new(),
        drawing: Drawing::default(),
    };
    for line in text.lines() {
        reader.line += 1;
        if let Err(mistake) = reader.statement(line) {
            reader.drawing.mistakes.push(mistake);
        }
    }
    reader.drawing
}

impl Reader<'_> {
    fn error(&self, found: impl Into<String>, expected: &str) -> TilesetError {
        TilesetError::Obj { path: self.path.into(), line: self.line, found: found.into(), expected: expected.into() }
    }

    fn statement(&mut self, text: &str) -> Result<(), TilesetError> {
        let mut words = text.split('#').next().unwrap_or("").split_whitespace();
        let Some(keyword) = words.next() else { return Ok(()) };
        let rest: Vec<&str> = words.collect();
        match keyword {
            "v" => self.vertex(&rest),
            "f" => self.element(&rest, true),
            "l" => self.element(&rest, false),
            "g" | "o" => {
                self.group = rest.join(" ");
                Ok(())
            }
            "usemtl" => {
                self.material = rest.join(" ");
                Ok(())
            }
            // Normals, texture, smoothing and the look of materials say nothing about the shape.
            "vn" | "vt" | "s" | "mtllib" => Ok(()),
            other => Err(self.error(
                format!("the keyword '{other}'"),
                "v, f, l, g, o or usemtl (vn, vt, s and mtllib are skipped); export polygons and lines only",
            )),
        }
    }

    fn vertex(&mut self, words: &[&str]) -> Result<(), TilesetError> {
        self.vertices.push(None);
        let mut point = [0.0; 3];
        if words.len() < 3 {
            return Err(self.error(format!("{} coordinates", words.len()), "three: v x y z"));
        }
        for (coordinate, word) in point.iter_mut().zip(words) {
            let value = word.parse::<f64>().ok().filter(|v| v.is_finite());
            *coordinate = value.ok_or_else(|| self.error(format!("'{word}'"), "a number"))?;
        }
        let mm = self.axes.to_mm(point);
        if let Some(far) = mm.into_iter().find(|c| c.abs() > 1e6) {
            let expected = "a place within a kilometre of the cube; move the tile to its cube, or correct the unit";
            return Err(self.error(format!("the coordinate {far} mm"), expected));
        }
        let [low, high] = self.drawing.bounds_mm.get_or_insert([mm; 2]);
        for a in 0..3 {
            low[a] = low[a].min(mm[a]);
            high[a] = high[a].max(mm[a]);
        }
        let steps = match self.grid {
            Grid::Millimetre => 1.0,
            Grid::Micrometre => 1000.0,
        };
        // Within a kilometre whole micrometres fit in an i32.
        let rounded = mm.map(|c| (c * steps).round() as i32);
        let last = self.vertices.len() - 1;
        self.vertices[last] = Some((rounded, self.line));
        let off = (0..3).find(|&a| (mm[a] - mm[a].round()).abs() > 0.01);
        match (self.grid, off) {
            (Grid::Millimetre, Some(axis)) => Err(self.error(
                format!("the coordinate {} mm", mm[axis]),
                "a whole number of millimetres; snap the vertex, or correct the unit",
            )),
            _ => Ok(()),
        }
    }

    fn element(&mut self, words: &[&str], is_polygon: bool) -> Result<(), TilesetError> {
        let least = if is_polygon { 3 } else { 2 };
        if words.len() < least || words.len() > 255 {
            return Err(self.error(
                format!("{} vertices", words.len()),
                if is_polygon { "3 to 255 in a polygon" } else { "2 to 255 in a line" },
            ));
        }
        let mut points = Vec::with_capacity(words.len());
        let mut point_lines = Vec::with_capacity(words.len());
        for word in words {
            // A vertex that is no number has been reported where it stands.
            let Some((point, line)) = self.lookup(word)? else { return Ok(()) };
            points.push(point);
            point_lines.push(line);
        }
        if is_polygon && self.axes.map.mirrors() {
            points.reverse();
            point_lines.reverse();
        }
        let [group, material] = [&self.group, &self.material].map(Clone::clone);
        self.drawing.elements.push(Element { group, material, line: self.line, points, point_lines, is_polygon });
        Ok(())
    }

    /// The vertex of `n`, `n/t`, `n//m` or `n/t/m`; negative numbers count backwards.
    fn lookup(&self, word: &str) -> Result<Option<([i32; 3], usize)>, TilesetError> {
        let number = word.split('/').next().and_then(|w| w.parse::<i64>().ok());
        let count = self.vertices.len() as i64;
        number
            .map(|n| if n < 0 { count + n } else { n - 1 })
            .and_then(|n| usize::try_from(n).ok())
            .and_then(|n| self.vertices.get(n).copied())
            .ok_or_else(|| {
                self.error(
                    format!("the vertex '{word}'"),
                    &format!("a number from 1 to {count}, of a vertex further up"),
                )
            })
    }
}

/// Writes elements as an OBJ text in mm: vertices sorted, elements grouped in the order given.
pub(super) fn write_obj(comment: &str, elements: &[(String, Vec<[i32; 3]>)], is_polygon: bool) -> String {
    let mut vertices: Vec<[i32; 3]> = elements.iter().flat_map(|e| e.1.iter().copied()).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let mut text = format!("# {comment}\n");
    for [x, y, z] in &vertices {
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    let mut group = "";
    for (name, points) in elements {
        if name != group {
            let _ = writeln!(text, "g {name}");
            group = name;
        }
        text.push(if is_polygon { 'f' } else { 'l' });
        for p in points {
            let _ = write!(text, " {}", vertices.partition_point(|v| v < p) + 1);
        }
        text.push('\n');
    }
    text
}
