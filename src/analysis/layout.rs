//! Where each stiffness goes: node order of least fill, equation numbers, and the block pattern of the lower triangle.
//!
//! Ordering works on nodes, not on dofs: the graph has a sixth of the rows and the factor the same fill, because the dofs of
//! a node are coupled among themselves. Columns of one node share one row pattern: first its own dofs, then those of later
//! neighbours, so a block is found with one search and its values with arithmetic.

use super::error::InputError;
use super::model::Model;
use super::tree::Tree;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

/// A dof without an equation: held, or idle.
pub(super) const NONE: u32 = u32::MAX;

/// Unknowns the 32-bit indices of the factor allow.
const LIMIT: usize = 1 << 24;

/// Equation numbers and block pattern. All vectors keep their capacity from frame to frame.
#[derive(Default)]
pub(super) struct Layout {
    /// Unknowns.
    pub n: usize,
    /// Equation of each dof of each node, or [`NONE`].
    pub equation: Vec<[u32; 6]>,
    /// Node at each place of the elimination order; nodes without unknowns are left out.
    pub node_at: Vec<u32>,
    /// First equation of each place, and `n` behind the last.
    pub start: Vec<u32>,
    /// Lower triangle by columns.
    pub col_ptr: Vec<u32>,
    pub row_idx: Vec<u32>,
    /// Upper triangle with the same fill, for the symbolic phase: of each block only the first column's rows.
    pub upper_ptr: Vec<u32>,
    pub upper_idx: Vec<u32>,
    /// How the columns of the factor follow from each other.
    pub tree: Tree,
    place: Vec<u32>,
    /// Later neighbours of each place, ascending, and the offset of their rows within a column.
    adj_ptr: Vec<u32>,
    adj: Vec<u32>,
    offset: Vec<u32>,
    fill: Vec<u32>,
    graph_ptr: Vec<u32>,
    graph_idx: Vec<u32>,
    perm: Vec<u32>,
    inverse: Vec<u32>,
    stack: Option<(usize, MemBuffer)>,
}

/// Lists of smaller (or larger) neighbours by counting sort: sorted, no duplicates.
pub(super) fn lists(n: usize, pairs: impl Iterator<Item = (u32, u32)> + Clone, ptr: &mut Vec<u32>, idx: &mut Vec<u32>) {
    ptr.clear();
    ptr.resize(n + 2, 0);
    pairs.clone().for_each(|(owner, _)| ptr[owner as usize + 2] += 1);
    (2..n + 2).for_each(|k| ptr[k] += ptr[k - 1]);
    idx.clear();
    idx.resize(ptr[n + 1] as usize, 0);
    for (owner, other) in pairs {
        let at = &mut ptr[owner as usize + 1];
        idx[*at as usize] = other;
        *at += 1;
    }
    let (mut write, mut read) = (0, 0);
    for k in 0..n {
        let end = ptr[k + 1] as usize;
        idx[read..end].sort_unstable();
        let begin = write;
        for r in read..end {
            if write == begin || idx[write - 1] != idx[r] {
                idx[write] = idx[r];
                write += 1;
            }
        }
        read = end;
        ptr[k + 1] = write as u32;
    }
    ptr.truncate(n + 1);
    idx.truncate(write);
}

impl Layout {
    /// Numbers the dofs for which `active` holds and lays out the pattern of `model`'s members.
    pub fn build(&mut self, model: &Model, active: &[[bool; 6]]) -> Result<(), InputError> {
        let unknowns: usize = active.iter().map(|a| a.iter().filter(|&&d| d).count()).sum();
        if unknowns > LIMIT || model.members.len() > LIMIT {
            return Err(InputError::TooLarge { unknowns, limit: LIMIT });
        }
        self.number_nodes(active);
        self.order(model);
        self.number_dofs(active, unknowns);
        self.neighbours(model);
        self.columns();
        self.symbolic_columns();
        self.tree.grow(&self.start, &self.adj_ptr, &self.adj);
        Ok(())
    }

    fn number_nodes(&mut self, active: &[[bool; 6]]) {
        self.node_at.clear();
        self.place.clear();
        for (node, dofs) in active.iter().enumerate() {
            if dofs.contains(&true) {
                self.place.push(self.node_at.len() as u32);
                self.node_at.push(node as u32);
            } else {
                self.place.push(NONE);
            }
        }
    }

    /// Minimum degree order of the node graph.
    fn order(&mut self, model: &Model) {
        let n = self.node_at.len();
        let place = &self.place;
        let pairs = model.members.iter().filter_map(|m| {
            let (a, b) = (place[m.nodes[0]], place[m.nodes[1]]);
            (a != NONE && b != NONE && a != b).then_some((a.max(b), a.min(b)))
        });
        lists(n, pairs, &mut self.graph_ptr, &mut self.graph_idx);
        self.perm.clear();
        self.perm.resize(n, 0);
        self.inverse.clear();
        self.inverse.resize(n, 0);
        let graph = SymbolicSparseColMatRef::new_checked(n, n, &self.graph_ptr, None, &self.graph_idx);
        let req = amd::order_scratch::<u32>(n, self.graph_idx.len() + n);
        let stack = grown(&mut self.stack, req);
        if amd::order(&mut self.perm, &mut self.inverse, graph, amd::Control::default(), stack).is_err() {
            // Only an overflow of the index type ends here, which LIMIT rules out; any order is correct.
            (0..n).for_each(|k| self.perm[k] = k as u32);
        }
        self.fill.clear();
        self.fill.extend_from_slice(&self.node_at);
        for (k, &p) in self.perm.iter().enumerate() {
            let node = self.fill[p as usize];
            self.node_at[k] = node;
            self.place[node as usize] = k as u32;
        }
    }

    fn number_dofs(&mut self, active: &[[bool; 6]], unknowns: usize) {
        self.n = unknowns;
        self.equation.clear();
        self.equation.resize(active.len(), [NONE; 6]);
        self.start.clear();
        let mut next = 0;
        for &node in &self.node_at {
            self.start.push(next);
            for (d, _) in active[node as usize].iter().enumerate().filter(|(_, a)| **a) {
                self.equation[node as usize][d] = next;
                next += 1;
            }
        }
        self.start.push(next);
    }

    fn neighbours(&mut self, model: &Model) {
        let place = &self.place;
        let pairs = model.members.iter().filter_map(|m| {
            let (a, b) = (place[m.nodes[0]], place[m.nodes[1]]);
            (a != NONE && b != NONE && a != b).then_some((a.min(b), a.max(b)))
        });
        lists(self.node_at.len(), pairs, &mut self.adj_ptr, &mut self.adj);
    }

    fn dofs_at(&self, place: u32) -> std::ops::Range<u32> {
        self.start[place as usize]..self.start[place as usize + 1]
    }

    fn columns(&mut self) {
        self.offset.clear();
        self.col_ptr.clear();
        self.row_idx.clear();
        for a in 0..self.node_at.len() as u32 {
            let own = self.dofs_at(a);
            let first = self.row_idx.len();
            self.row_idx.extend(own.clone());
            for k in self.adj_ptr[a as usize]..self.adj_ptr[a as usize + 1] {
                self.offset.push((self.row_idx.len() - first) as u32);
                let rows = self.dofs_at(self.adj[k as usize]);
                self.row_idx.extend(rows);
            }
            let height = self.row_idx.len() - first;
            for c in 0..own.len() {
                self.col_ptr.push((first + c * height) as u32);
                if c > 0 {
                    self.row_idx.extend_from_within(first..first + height);
                }
            }
        }
        self.col_ptr.push(self.row_idx.len() as u32);
    }

    /// Row `r` of the lower triangle couples to the first dof of its own node and of every earlier neighbour.
    fn symbolic_columns(&mut self) {
        self.fill.clear();
        self.fill.resize(self.n + 1, 0);
        self.each_symbolic(|_, row, fill| fill[row as usize + 1] += 1);
        (0..self.n).for_each(|k| self.fill[k + 1] += self.fill[k]);
        self.upper_ptr.clear();
        self.upper_ptr.extend_from_slice(&self.fill);
        let mut upper = std::mem::take(&mut self.upper_idx);
        upper.clear();
        upper.resize(self.fill[self.n] as usize, 0);
        self.each_symbolic(|first, row, fill| {
            upper[fill[row as usize] as usize] = first;
            fill[row as usize] += 1;
        });
        self.upper_idx = upper;
    }

    fn each_symbolic(&mut self, mut visit: impl FnMut(u32, u32, &mut [u32])) {
        for a in 0..self.node_at.len() {
            let first = self.start[a];
            let (begin, end) = (self.col_ptr[first as usize] as usize, self.col_ptr[first as usize + 1] as usize);
            self.row_idx[begin..end].iter().for_each(|&row| visit(first, row, &mut self.fill));
        }
    }

    /// Bytes of equation numbers and patterns.
    pub fn bytes(&self) -> usize {
        let lists =
            [&self.node_at, &self.start, &self.col_ptr, &self.row_idx, &self.upper_ptr, &self.upper_idx, &self.place];
        let more = [&self.adj_ptr, &self.adj, &self.offset, &self.fill, &self.graph_ptr, &self.graph_idx, &self.perm];
        let tree = [&self.tree.ptr, &self.tree.idx, &self.tree.counts];
        4 * (6 * self.equation.len() + lists.iter().chain(&more).chain(&tree).map(|l| l.len()).sum::<usize>())
    }

    /// Place of a diagonal entry among the values.
    pub fn diagonal(&self, equation: usize) -> usize {
        // Rows of a node's columns begin with its own dofs, so the diagonal is as deep as the column is late.
        let begin = self.col_ptr[equation] as usize;
        begin + (equation - self.row_idx[begin] as usize)
    }

    /// `out += K v` for the lower triangle `values`.
    pub fn multiply(&self, values: &[f64], v: &[f64], out: &mut [f64]) {
        for c in 0..self.n {
            let column = self.col_ptr[c] as usize..self.col_ptr[c + 1] as usize;
            for (&r, &value) in self.row_idx[column.clone()].iter().zip(&values[column]) {
                let r = r as usize;
                // The own block is stored whole, the others once.
                if r >= c {
                    out[r] += value * v[c];
                }
                if r > c {
                    out[c] += value * v[r];
                }
            }
        }
    }

    /// Adds a 6 x 6 block of node `i` to the diagonal of `values`.
    pub fn add_diagonal(&self, i: usize, block: &[[f64; 6]; 6], values: &mut [f64]) {
        let place = self.place[i];
        if place == NONE {
            return;
        }
        let (first, eq) = (self.start[place as usize], &self.equation[i]);
        for (c, &col) in eq.iter().enumerate().filter(|(_, e)| **e != NONE) {
            let base = self.col_ptr[col as usize] as usize;
            for (r, &row) in eq.iter().enumerate().filter(|(_, e)| **e != NONE) {
                values[base + (row - first) as usize] += block[r][c];
            }
        }
    }

    /// Adds the block of node `i` (rows) and node `j` (columns), on whichever side of the diagonal the order puts it.
    pub fn add_coupling(&self, i: usize, j: usize, block: &[[f64; 6]; 6], values: &mut [f64]) {
        let (pi, pj) = (self.place[i], self.place[j]);
        if pi == NONE || pj == NONE {
            return;
        }
        let (a, b) = (pi.min(pj), pi.max(pj));
        let list = self.adj_ptr[a as usize] as usize..self.adj_ptr[a as usize + 1] as usize;
        let Ok(slot) = self.adj[list.clone()].binary_search(&b) else { return };
        let offset = (self.offset[list.start + slot]) as usize;
        let (rows, cols) = if pi > pj { (i, j) } else { (j, i) };
        let first = self.start[b as usize];
        for (c, &col) in self.equation[cols].iter().enumerate().filter(|(_, e)| **e != NONE) {
            let base = self.col_ptr[col as usize] as usize + offset;
            for (r, &row) in self.equation[rows].iter().enumerate().filter(|(_, e)| **e != NONE) {
                values[base + (row - first) as usize] += if pi > pj { block[r][c] } else { block[c][r] };
            }
        }
    }
}

/// A stack of at least `req` bytes, grown only when a frame needs more than any before. What is allocated is what is counted:
/// the bytes for any alignment, or a later request of other alignment would find the stack too short.
pub(super) fn grown(slot: &mut Option<(usize, MemBuffer)>, req: StackReq) -> &mut MemStack {
    let need = req.unaligned_bytes_required();
    if slot.as_ref().is_none_or(|(have, _)| *have < need) {
        *slot = None;
    }
    let (_, buffer) = slot.get_or_insert_with(|| (need, MemBuffer::new(StackReq::new_aligned::<u8>(need, 128))));
    MemStack::new(buffer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stack_serves_requests_of_any_alignment() {
        let mut slot = None;
        // 1,000 bytes at 512 count as 1,511; the second asks for more bytes of less alignment.
        grown(&mut slot, StackReq::new_aligned::<u8>(1000, 512));
        let (bytes, _) = grown(&mut slot, StackReq::new_aligned::<u8>(1400, 8)).make_with(1400, |_| 0u8);
        assert_eq!(bytes.len(), 1400);
    }
}
