//! Reads lattice CSV and remembers how it was written.

use super::number::spell;
use super::{Lattice, LatticeError, RowOrder, Style, Values, cell_of_row};

/// One line without its ending; `number` counts from 1.
struct Line<'t> {
    number: usize,
    text: &'t str,
}

/// One row of the table: its cell, the text of its value, its line.
struct Row<'t> {
    cell: [usize; 3],
    value: &'t str,
    line: usize,
}

/// Reads a lattice of either kind; `source` names it in errors.
///
/// # Errors
/// Text that is not UTF-8, ragged rows, values that are neither True, False nor a number, and cells that are missing,
/// repeated or out of order, each with its line.
pub fn read_lattice(bytes: &[u8], source: &str) -> Result<Lattice, LatticeError> {
    let text = std::str::from_utf8(bytes).map_err(|e| {
        let line = bytes[..e.valid_up_to()].iter().filter(|b| **b == b'\n').count() + 1;
        fail(source, line, "bytes that are no UTF-8", "a text file in UTF-8")
    })?;
    let mut style = Style::default();
    let mut lines = split(text, &mut style, source)?;
    let head = match lines.first() {
        Some(line) if line.text == "minbound,shape,unit" => Some(read_metadata(&lines, &mut style, source)?),
        Some(_) => None,
        None => return Err(fail(source, 1, "", "`minbound,shape,unit` or `IX,IY,IZ,value`")),
    };
    style.metadata = head.is_some();
    lines.drain(..if head.is_some() { 5 } else { 0 });
    style.value_column = read_header(lines.first(), source)?;
    let rows = lines[1..].iter().map(|line| read_row(line, source)).collect::<Result<Vec<_>, _>>()?;
    let shape = match &head {
        Some((_, shape, _)) => *shape,
        None => [0, 1, 2].map(|a| rows.iter().map(|r| r.cell[a]).max().map_or(0, |m| m.saturating_add(1))),
    };
    style.order = check_order(&rows, shape, head.is_some(), source)?;
    let values = read_values(&rows, shape, &mut style, source)?;
    let (minbound, _, unit) = head.unwrap_or(([0.0; 3], shape, [1.0; 3]));
    Ok(Lattice { shape, minbound, unit, values, style })
}

fn fail(source: &str, line: usize, found: &str, expected: &str) -> LatticeError {
    let (file, found, expected) = (source.to_string(), found.chars().take(60).collect(), expected.to_string());
    LatticeError::Line { file, line, found, expected }
}

/// Cuts the text into lines and notes their endings and what follows the last row.
fn split<'t>(text: &'t str, style: &mut Style, source: &str) -> Result<Vec<Line<'t>>, LatticeError> {
    let mut lines = Vec::new();
    style.final_newline = text.ends_with('\n');
    for (n, piece) in text.split_inclusive('\n').enumerate() {
        let ended = piece.strip_suffix('\n');
        let content = ended.map_or(piece, |p| p.trim_end_matches('\r'));
        let returns = ended.map_or(0, |p| p.len() - content.len());
        if content.contains('\r') || returns > 2 {
            return Err(fail(source, n + 1, "a stray carriage return", "lines ending with LF, CR LF or CR CR LF"));
        }
        if ended.is_some() {
            match style.endings.last_mut() {
                Some((r, count)) if *r as usize == returns => *count += 1,
                _ => style.endings.push((returns as u8, 1)),
            }
        }
        lines.push(Line { number: n + 1, text: content });
    }
    while lines.last().is_some_and(|l| l.text.is_empty()) {
        lines.pop();
        style.trailing_blank += 1;
    }
    Ok(lines)
}

type Head = ([f64; 3], [usize; 3], [f64; 3]);

fn read_metadata(lines: &[Line], style: &mut Style, source: &str) -> Result<Head, LatticeError> {
    let (mut minbound, mut shape, mut unit) = ([0.0; 3], [0; 3], [0.0; 3]);
    for a in 0..3 {
        let Some(line) = lines.get(a + 1) else {
            return Err(fail(
                source,
                a + 2,
                "the end of the file",
                "three metadata rows: minbound,shape,unit for x, y, z",
            ));
        };
        let cells: Vec<&str> = line.text.split(',').collect();
        let number = |at: usize| {
            let read: Option<f64> = cells.get(at).and_then(|c| c.trim().parse().ok()).filter(|v: &f64| v.is_finite());
            read.filter(|_| cells.len() == 3)
                .ok_or_else(|| fail(source, line.number, line.text, "three numbers: minbound,shape,unit of one axis"))
        };
        (minbound[a], unit[a]) = (number(0)?, number(2)?);
        let size = number(1)?;
        if size.fract() != 0.0 || !(1.0..=1e6).contains(&size) || unit[a] <= 0.0 {
            return Err(fail(source, line.number, line.text, "a whole shape of at least 1 and a unit above 0"));
        }
        shape[a] = size as usize;
        for (c, value) in [minbound[a], size, unit[a]].into_iter().enumerate() {
            if spell(value) != cells[c] {
                style.spelled_meta.push((3 * a + c, cells[c].to_string()));
            }
        }
    }
    match lines.get(4) {
        Some(line) if line.text.is_empty() => Ok((minbound, shape, unit)),
        other => {
            let (line, found) = other.map_or((5, "the end of the file"), |l| (l.number, l.text));
            Err(fail(source, line, found, "an empty line after the metadata rows"))
        }
    }
}

fn read_header(line: Option<&Line>, source: &str) -> Result<String, LatticeError> {
    let (number, text) = line.map_or((1, "the end of the file"), |l| (l.number, l.text));
    let column = text.strip_prefix("IX,IY,IZ,").filter(|c| !c.is_empty() && !c.contains(','));
    column.map(str::to_string).ok_or_else(|| {
        fail(source, number, text, "`IX,IY,IZ,value`, after `minbound,shape,unit` and its rows or without them")
    })
}

fn read_row<'t>(line: &Line<'t>, source: &str) -> Result<Row<'t>, LatticeError> {
    let error = || fail(source, line.number, line.text, "four columns: three whole indices and a value");
    let mut cells = line.text.split(',');
    let mut index = || {
        let text = cells.next()?;
        let value: usize = text.parse().ok()?;
        (value.to_string() == text).then_some(value)
    };
    let cell = [index(), index(), index()];
    let [Some(x), Some(y), Some(z)] = cell else { return Err(error()) };
    let (Some(value), None) = (cells.next(), cells.next()) else { return Err(error()) };
    Ok(Row { cell: [x, y, z], value, line: line.number })
}

/// The order of the rows, when each cell stands exactly where it should.
fn check_order(rows: &[Row], shape: [usize; 3], metadata: bool, source: &str) -> Result<RowOrder, LatticeError> {
    let orders: &[RowOrder] = if metadata { &[RowOrder::C] } else { &[RowOrder::C, RowOrder::F] };
    let line = rows.last().map_or(1, |r| r.line);
    let count = |expected: usize| LatticeError::Count { file: source.into(), line, found: rows.len(), expected, shape };
    let cells = shape.iter().try_fold(1usize, |n, s| n.checked_mul(*s));
    let Some(expected) = cells.filter(|n| *n > 0) else { return Err(count(cells.unwrap_or(usize::MAX))) };
    // The order that holds longest is the one meant; its first breach is the error.
    let meant = orders.iter().map(|&order| (rows_in_order(rows, shape, order), order)).rev().max_by_key(|(n, _)| *n);
    match meant {
        Some((n, order)) if n < rows.len().min(expected) => {
            let (found, expected) = (rows[n].cell, cell_of_row(n, shape, order));
            let cause = if rows[..n].iter().any(|r| r.cell == found) {
                "the cell is repeated"
            } else if rows.iter().any(|r| r.cell == expected) {
                "the rows are shuffled"
            } else {
                "a row is missing"
            };
            Err(LatticeError::Order { file: source.into(), line: rows[n].line, found, expected, cause })
        }
        _ if rows.len() != expected => Err(count(expected)),
        Some((_, order)) => Ok(order),
        None => Err(count(expected)),
    }
}

/// Rows from the first that stand in an order.
fn rows_in_order(rows: &[Row], shape: [usize; 3], order: RowOrder) -> usize {
    rows.iter().enumerate().take_while(|(n, row)| cell_of_row(*n, shape, order) == row.cell).count()
}

fn read_values(rows: &[Row], shape: [usize; 3], style: &mut Style, source: &str) -> Result<Values, LatticeError> {
    let [nx, ny, _] = shape;
    let at = |[x, y, z]: [usize; 3]| x + nx * (y + ny * z);
    if rows.first().is_some_and(|r| r.value == "True" || r.value == "False") {
        let mut values = vec![false; rows.len()];
        for row in rows {
            values[at(row.cell)] = match row.value {
                "True" => true,
                "False" => false,
                other => return Err(fail(source, row.line, other, "True or False, as in the rows above")),
            };
        }
        return Ok(Values::Bool(values));
    }
    let mut values = vec![0.0; rows.len()];
    for (n, row) in rows.iter().enumerate() {
        let value = row.value.trim().parse().ok().filter(|v: &f64| v.is_finite());
        let value =
            value.ok_or_else(|| fail(source, row.line, row.value, "a finite number, or True and False throughout"))?;
        if spell(value) != row.value {
            style.spelled.push((n, row.value.to_string()));
        }
        values[at(row.cell)] = value;
    }
    Ok(Values::Number(values))
}
