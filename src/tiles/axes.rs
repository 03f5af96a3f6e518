//! How the coordinates of a designer's files become the cube's own: unit, axes and pivot, stated in the manifest and converted here.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The units a manifest may state, with their length in mm. `cube` is a unit cube: one in a file is one module along each axis.
pub const UNITS: [(&str, f64); 5] = [("mm", 1.0), ("cm", 10.0), ("m", 1000.0), ("inch", 25.4), ("cube", 1.0)];

/// Where in the cube the origin of the files is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Pivot {
    /// `corner` (the lowest x, y, z), `centre`, or `base_centre` (middle of the bottom face).
    Named(#[schemars(extend("enum" = ["corner", "centre", "base_centre"]))] String),
    /// The point of the cube, in the manifest's unit along the cube's axes.
    At([f64; 3]),
}

impl Default for Pivot {
    fn default() -> Pivot {
        Pivot::Named("corner".into())
    }
}

impl Pivot {
    /// The point in mm for a cube of this size; `scale` are millimetres per unit along the cube's axes. `None` for an unknown name.
    pub(super) fn point_mm(&self, module_mm: [f64; 3], scale: [f64; 3]) -> Option<[f64; 3]> {
        let [x, y, z] = module_mm;
        match self {
            Pivot::Named(name) => match name.as_str() {
                "corner" => Some([0.0; 3]),
                "centre" => Some([x / 2.0, y / 2.0, z / 2.0]),
                "base_centre" => Some([x / 2.0, y / 2.0, 0.0]),
                _ => None,
            },
            Pivot::At(at) => at.iter().all(|c| c.is_finite()).then(|| [0, 1, 2].map(|a| at[a] * scale[a])),
        }
    }
}

/// Which axis of the cube each file axis runs along, and in which sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AxisMap([(u8, i8); 3]);

impl AxisMap {
    /// File axes are the cube's.
    pub const Z_UP: AxisMap = AxisMap([(0, 1), (1, 1), (2, 1)]);

    /// The usual y-up files (Houdini, glTF, Blender's exporter): the second file axis runs up, the third towards -y.
    pub const Y_UP: AxisMap = AxisMap([(0, 1), (2, 1), (1, -1)]);

    /// `z`, `y` or three signed letters such as `x,z,-y`: where the first, second and third file axis go.
    pub fn parse(text: &str) -> Option<AxisMap> {
        match text {
            "z" | "Z" => return Some(AxisMap::Z_UP),
            "y" | "Y" => return Some(AxisMap::Y_UP),
            _ => {}
        }
        let mut axes = Vec::with_capacity(3);
        for word in text.split(',') {
            let word = word.trim();
            let (sign, letter) = match word.strip_prefix('-') {
                Some(rest) => (-1, rest),
                None => (1, word.strip_prefix('+').unwrap_or(word)),
            };
            axes.push((["x", "y", "z"].iter().position(|l| *l == letter)? as u8, sign));
        }
        let axes: [(u8, i8); 3] = axes.try_into().ok()?;
        (0..3).all(|a| axes.iter().any(|&(to, _)| to == a)).then_some(AxisMap(axes))
    }

    /// As [`AxisMap::parse`] reads it, always as three letters.
    pub fn name(self) -> String {
        self.0
            .map(|(to, sign)| format!("{}{}", if sign < 0 { "-" } else { "" }, ["x", "y", "z"][to as usize]))
            .join(",")
    }

    /// This map, then another one.
    pub fn then(self, other: AxisMap) -> AxisMap {
        AxisMap(self.0.map(|(to, sign)| {
            let (on, turned) = other.0[to as usize];
            (on, sign * turned)
        }))
    }

    /// How a manifest states it: `z` or `y` where one of these says it, else three letters.
    pub fn up_axis(self) -> String {
        match self {
            AxisMap::Z_UP => "z".into(),
            AxisMap::Y_UP => "y".into(),
            other => other.name(),
        }
    }

    /// A point of a file along the cube's axes.
    pub fn turn(self, point: [f64; 3]) -> [f64; 3] {
        let mut turned = [0.0; 3];
        for (value, (to, sign)) in point.into_iter().zip(self.0) {
            turned[to as usize] = value * f64::from(sign);
        }
        turned
    }

    /// Whether the map is a mirror: left-handed files.
    pub fn mirrors(self) -> bool {
        let [a, b, c] = self.0.map(|(to, _)| to);
        let odd = ![(0, 1, 2), (1, 2, 0), (2, 0, 1)].contains(&(a, b, c));
        let signs: i8 = self.0.iter().map(|(_, sign)| sign).product();
        odd != (signs < 0)
    }
}

/// From file coordinates to cube-local millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Where file axes go.
    pub map: AxisMap,
    /// Millimetres per file unit along each axis of the cube.
    pub scale: [f64; 3],
    /// The cube's point at the file's origin, mm.
    pub origin_mm: [f64; 3],
}

impl Axes {
    /// Files in mm, z up, origin in the cube's first corner.
    pub const PLAIN: Axes = Axes { map: AxisMap::Z_UP, scale: [1.0; 3], origin_mm: [0.0; 3] };

    /// A point of a file in the cube, mm.
    pub fn to_mm(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = self.map.turn(point);
        [0, 1, 2].map(|a| turned[a] * self.scale[a] + self.origin_mm[a])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_say_where_file_axes_go() {
        let web = AxisMap::parse("x,z,-y").expect("a map");
        assert_eq!(web, AxisMap::Y_UP);
        assert_eq!(web.turn([1.0, 2.0, 3.0]), [1.0, -3.0, 2.0], "file up is up, file depth is towards the front");
        assert!(!web.mirrors() && !AxisMap::Z_UP.mirrors());
        assert!(AxisMap::parse("x,z,y").expect("a map").mirrors());
        assert!(!AxisMap::parse("y,-x,z").expect("a map").mirrors());
        for wrong in ["x,y", "x,x,z", "x,y,w", "", "x,y,z,z", "--x,y,z"] {
            assert_eq!(AxisMap::parse(wrong), None, "{wrong}");
        }
        for name in ["x,z,-y", "-x,-y,z", "z,x,y"] {
            assert_eq!(AxisMap::parse(name).expect("a map").name(), name);
        }
    }

    #[test]
    fn a_centred_unit_cube_fills_the_module() {
        let module = [900.0, 900.0, 540.0];
        let origin_mm = Pivot::Named("centre".into()).point_mm(module, module).expect("a point");
        let axes = Axes { map: AxisMap::Z_UP, scale: module, origin_mm };
        assert_eq!(axes.to_mm([-0.5; 3]), [0.0; 3]);
        assert_eq!(axes.to_mm([0.5; 3]), module);
        assert_eq!(Pivot::Named("middle".into()).point_mm(module, module), None);
        assert_eq!(Pivot::At([0.5, 0.0, 1.0]).point_mm(module, module), Some([450.0, 0.0, 540.0]));
    }
}
