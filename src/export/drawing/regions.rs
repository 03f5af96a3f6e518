//! Areas of one tone on a raster as loops, for fills under the lines.

use super::raster::Raster;

/// Loops smaller than this are specks, cells.
const SPECK: f64 = 14.0;

/// How far a simplified border may lie off, cells.
const OFF: f64 = 1.05;

/// A border between cells from corner to corner, the tone on its right (rows run down).
#[derive(Clone, Copy)]
struct Border {
    tone: u8,
    from: [u32; 2],
    to: [u32; 2],
}

/// The areas of each tone but 0, by tone: closed loops in m, right and up, to be filled even-odd.
pub fn regions(raster: &Raster, tones: &[u8]) -> Vec<(u8, Vec<Vec<[f64; 2]>>)> {
    let mut borders = borders(raster.size, tones);
    borders.sort_unstable_by_key(|b| (b.tone, b.from, b.to));
    let mut used = vec![false; borders.len()];
    let mut found: Vec<(u8, Vec<Vec<[f64; 2]>>)> = Vec::new();
    for start in 0..borders.len() {
        let tone = borders[start].tone;
        let mut corners: Vec<[f64; 2]> = Vec::new();
        let mut next = (!used[start]).then_some(start);
        while let Some(n) = next {
            used[n] = true;
            corners.push(borders[n].from.map(f64::from));
            let wanted = (tone, borders[n].to);
            let first = borders.partition_point(|b| (b.tone, b.from) < wanted);
            next = (first..borders.len())
                .take_while(|&i| (borders[i].tone, borders[i].from) == wanted)
                .find(|&i| !used[i]);
        }
        if corners.len() < 4 || area(&corners).abs() < SPECK {
            continue;
        }
        let corners: Vec<[f64; 2]> = simple(&corners).into_iter().map(|c| raster.metres(c)).collect();
        match found.last_mut() {
            Some((last, loops)) if *last == tone => loops.push(corners),
            _ => found.push((tone, vec![corners])),
        }
    }
    found
}

/// The borders of all tones, straight on as long as the tones on both sides stay.
fn borders([w, h]: [usize; 2], tones: &[u8]) -> Vec<Border> {
    let tone = |x: usize, y: usize| if x < w && y < h { tones[x + w * y] } else { 0 };
    let mut borders = Vec::new();
    let mut put = |pair: [u8; 2], a: [usize; 2], b: [usize; 2]| {
        let [a, b] = [a, b].map(|p| p.map(|c| c as u32));
        if pair[0] != 0 {
            borders.push(Border { tone: pair[0], from: b, to: a });
        }
        if pair[1] != 0 {
            borders.push(Border { tone: pair[1], from: a, to: b });
        }
    };
    let before = usize::wrapping_sub;
    for y in 0..=h {
        let (mut start, mut last) = (0, [0, 0]);
        for x in 0..=w {
            let pair = if x < w { [tone(x, before(y, 1)), tone(x, y)] } else { [0, 0] };
            if pair != last {
                if last[0] != last[1] {
                    put(last, [start, y], [x, y]);
                }
                (start, last) = (x, pair);
            }
        }
    }
    // Column by column, in strips of rows so that the raster is read in order.
    let mut open: Vec<(usize, [u8; 2])> = vec![(0, [0, 0]); w + 1];
    for y in 0..=h {
        for (x, (start, last)) in open.iter_mut().enumerate() {
            let pair = if y < h { [tone(x, y), tone(before(x, 1), y)] } else { [0, 0] };
            if pair != *last {
                if last[0] != last[1] {
                    put(*last, [x, *start], [x, y]);
                }
                (*start, *last) = (y, pair);
            }
        }
    }
    borders
}

fn area(corners: &[[f64; 2]]) -> f64 {
    let n = corners.len();
    (0..n).map(|i| (corners[i], corners[(i + 1) % n])).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

/// A loop with fewer corners (Ramer 1972, Douglas and Peucker 1973), from its first corner and the one farthest from it.
fn simple(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let first = corners[0];
    let distance = |p: &[f64; 2]| (p[0] - first[0]).hypot(p[1] - first[1]);
    let far = (0..corners.len()).max_by(|&a, &b| distance(&corners[a]).total_cmp(&distance(&corners[b]))).unwrap_or(0);
    let mut kept = Vec::new();
    let closed: Vec<[f64; 2]> = corners.iter().copied().chain([first]).collect();
    thin(&closed[..=far], &mut kept);
    thin(&closed[far..], &mut kept);
    kept
}

/// The corners of a line to be kept, without the last.
fn thin(line: &[[f64; 2]], kept: &mut Vec<[f64; 2]>) {
    let mut stack = vec![(0, line.len() - 1)];
    while let Some((a, b)) = stack.pop() {
        let (p, q) = (line[a], line[b]);
        let d = [q[0] - p[0], q[1] - p[1]];
        let length = d[0].hypot(d[1]).max(1e-12);
        let off = |i: usize| ((line[i][0] - p[0]) * d[1] - (line[i][1] - p[1]) * d[0]).abs() / length;
        let worst = (a + 1..b).max_by(|&i, &j| off(i).total_cmp(&off(j))).filter(|&i| off(i) > OFF);
        match worst {
            Some(i) => {
                stack.push((i, b));
                stack.push((a, i));
            }
            None => kept.push(p),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn raster(size: [usize; 2]) -> Raster {
        Raster { size, cell: 1.0, corner: [0.0, 0.0], face: Vec::new(), depth: Vec::new() }
    }

    #[test]
    fn a_frame_has_two_loops_and_what_fills_it_one() {
        let size = [20, 16];
        let tone = |i: usize| match (i % 20, i / 20) {
            (5..=14, 4..=11) => 2,
            (1..=18, 1..=14) => 1,
            _ => 0,
        };
        let tones: Vec<u8> = (0..size[0] * size[1]).map(tone).collect();
        let found = regions(&raster(size), &tones);
        let areas: Vec<(u8, Vec<f64>)> =
            found.iter().map(|(t, l)| (*t, l.iter().map(|l| area(l).abs()).collect())).collect();
        assert_eq!(areas, [(1, vec![18.0 * 14.0, 80.0]), (2, vec![80.0])]);
        assert!(found.iter().flat_map(|f| &f.1).all(|l| l.len() == 4));
    }

    #[test]
    fn stairs_of_cells_become_a_slope() {
        let size = [200, 120];
        let tones: Vec<u8> = (0..200 * 120).map(|i| u8::from((i % 200) * 6 / 10 > i / 200)).collect();
        let found = regions(&raster(size), &tones);
        assert!(found.len() == 1 && found[0].1.len() == 1 && found[0].1[0].len() <= 5, "{found:?}");
    }
}
