//! Frame, title block, scale bar and north arrow of a sheet.

use super::pens::{FINE, FRAME};
use super::sheet::{EDGE, Hold, QUIET, Sheet, TEXT, TITLE, width};

/// What the title block says.
#[derive(Clone, Debug, Default)]
pub struct Title {
    /// Of the house.
    pub house: String,
    /// Of the drawing.
    pub drawing: String,
    /// Level of a storey, side of an elevation: one short line.
    pub level: String,
    /// Further lines, each a sentence.
    pub notes: Vec<String>,
    /// Whether north is up.
    pub north: bool,
}

/// Draws the frame and the title block.
pub fn draw(sheet: &mut Sheet, title: &Title) {
    let ([w, h], scale) = (sheet.format.paper.size, sheet.format.scale);
    let (left, right, bottom) = (EDGE, w - EDGE, h - EDGE);
    let top = bottom - TITLE;
    sheet.open("title");
    let corners = vec![[left, EDGE], [right, EDGE], [right, bottom], [left, bottom]];
    sheet.paths(FRAME, &[corners], true, "none");
    let block = right - 92.0;
    let marks = block - 52.0;
    sheet.paths(
        FRAME,
        &[vec![[left, top], [right, top]], vec![[block, top], [block, bottom]], vec![[marks, top], [marks, bottom]]],
        false,
        "none",
    );
    let x = block + 3.0;
    sheet.write(&shortened(&title.drawing, 5.0, 60.0), [x, top + 7.2], 5.0, Hold::Start, TEXT, " font-weight=\"600\"");
    sheet.text(&shortened(&title.house, 3.2, 84.0), [x, top + 12.8], 3.2, Hold::Start, TEXT);
    sheet.text(&title.level, [x, top + 17.4], 2.6, Hold::Start, QUIET);
    sheet.text("indicative, not for construction", [x, top + 21.8], 2.3, Hold::Start, QUIET);
    sheet.write(&format!("1:{scale}"), [right - 3.0, top + 7.2], 5.0, Hold::End, TEXT, " font-weight=\"600\"");
    sheet.text(sheet.format.paper.name, [right - 3.0, top + 12.8], 3.2, Hold::End, QUIET);
    scale_bar(sheet, [marks + 4.0, bottom - 8.0], 41.0);
    if title.north {
        north(sheet, [block - 8.0, top + 9.5]);
    }
    let lines = title.notes.iter().flat_map(|note| wrapped(note, 2.3, marks - left - 6.0));
    for (n, line) in lines.enumerate().take(7) {
        sheet.text(&line, [left + 3.0, top + 4.4 + 3.2 * n as f64], 2.3, Hold::Start, QUIET);
    }
    sheet.close();
}

/// A text in lines that fit, broken between words.
fn wrapped(words: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(word, size) + size < room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A text cut to what fits, with an ellipsis.
fn shortened(words: &str, size: f64, room: f64) -> String {
    if width(words, size) <= room {
        return words.to_owned();
    }
    let count = (room / (0.56 * size)).max(1.0) as usize;
    words.chars().take(count.saturating_sub(1)).chain(['…']).collect()
}

/// Whole metres in black and white, at most `room` mm.
fn scale_bar(sheet: &mut Sheet, [x, y]: [f64; 2], room: f64) {
    let metre = sheet.mm(1.0);
    let steps: [f64; 6] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0];
    let step = steps.into_iter().rev().find(|s| 2.0 * s * metre <= room).unwrap_or(0.5);
    let count = ((room / (step * metre)) as usize).clamp(1, 3);
    for n in 0..count {
        let (a, b) = (x + n as f64 * step * metre, x + (n + 1) as f64 * step * metre);
        let fill = if n % 2 == 0 { "#2a2d30" } else { "#fff" };
        sheet.paths(FINE, &[vec![[a, y], [b, y], [b, y + 1.6], [a, y + 1.6]]], true, fill);
    }
    for n in 0..=count {
        let at = [x + n as f64 * step * metre, y - 1.0];
        let words = format!("{}", n as f64 * step);
        sheet.text(&if n == count { format!("{words} m") } else { words }, at, 2.3, Hold::Middle, TEXT);
    }
    sheet.text("dimensions in mm, levels in m", [x, y + 5.0], 2.1, Hold::Start, QUIET);
}

/// An arrow to the top of the page.
fn north(sheet: &mut Sheet, [x, y]: [f64; 2]) {
    sheet.circle(FINE, [x, y], 4.6, "none");
    sheet.paths(FINE, &[vec![[x, y - 4.6], [x + 2.4, y + 3.9], [x, y + 2.2]]], true, "#fff");
    sheet.paths(FINE, &[vec![[x, y - 4.6], [x - 2.4, y + 3.9], [x, y + 2.2]]], true, "#2a2d30");
    sheet.text("N", [x, y - 5.6], 2.8, Hold::Middle, TEXT);
}
