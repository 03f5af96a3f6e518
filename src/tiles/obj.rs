//! Reading and writing the OBJ subset of tiles: vertices, groups, polygons, lines. Every element keeps its line number, which a
//! general OBJ reader does not give and without which a designer cannot find a mistake.

use super::TilesetError;
use std::fmt::Write;
use std::path::Path;

/// A polygon or a polyline with its group and line numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Element {
    /// Group (or object) it belongs to.
    pub group: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Vertices in cube-local mm.
    pub points: Vec<[i32; 3]>,
    /// Line of each vertex.
    pub point_lines: Vec<usize>,
    /// Polygon (`f`) or line (`l`).
    pub is_polygon: bool,
}

struct Reader<'a> {
    path: &'a Path,
    to_mm: f64,
    line: usize,
    group: String,
    vertices: Vec<([i32; 3], usize)>,
    elements: Vec<Element>,
}

/// Reads the elements of an OBJ text; `to_mm` is the length of its unit in mm.
pub(super) fn read_obj(text: &str, path: &Path, to_mm: f64) -> Result<Vec<Element>, TilesetError> {
    let mut reader = Reader { path, to_mm, line: 0, group: String::new(), vertices: Vec::new(), elements: Vec::new() };
    for line in text.lines() {
        reader.line += 1;
        reader.statement(line)?;
    }
    Ok(reader.elements)
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
            // Normals, texture, smoothing and materials say nothing about the shape.
            "vn" | "vt" | "s" | "usemtl" | "mtllib" => Ok(()),
            other => Err(self.error(
                format!("the keyword '{other}'"),
                "v, f, l, g or o (vn, vt, s, usemtl and mtllib are skipped); export polygons and lines only",
            )),
        }
    }

    fn vertex(&mut self, words: &[&str]) -> Result<(), TilesetError> {
        let mut point = [0; 3];
        if words.len() < 3 {
            return Err(self.error(format!("{} coordinates", words.len()), "three: v x y z"));
        }
        for (coordinate, word) in point.iter_mut().zip(words) {
            let value = word.parse::<f64>().ok().filter(|v| v.is_finite());
            let mm = value.ok_or_else(|| self.error(format!("'{word}'"), "a number"))? * self.to_mm;
            if (mm - mm.round()).abs() > 0.01 || mm.abs() > 1e6 {
                return Err(self.error(
                    format!("the coordinate {word} ({mm} mm)"),
                    "a whole number of millimetres within a kilometre of the cube; snap the vertex, or correct the unit",
                ));
            }
            *coordinate = mm.round() as i32;
        }
        self.vertices.push((point, self.line));
        Ok(())
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
            let (point, line) = self.lookup(word)?;
            points.push(point);
            point_lines.push(line);
        }
        self.elements.push(Element { group: self.group.clone(), line: self.line, points, point_lines, is_polygon });
        Ok(())
    }

    /// The vertex of `n`, `n/t`, `n//m` or `n/t/m`; negative numbers count backwards.
    fn lookup(&self, word: &str) -> Result<([i32; 3], usize), TilesetError> {
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
