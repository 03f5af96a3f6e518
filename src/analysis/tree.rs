//! Elimination tree and column counts of the factor, found on the nodes.
//!
//! The dofs of a node follow each other in the tree, and the columns of a node reach the same rows below it. So a graph of a sixth of
//! the rows tells all of it.

use super::layout::{NONE, lists};

/// Elimination tree of the unknowns and the sizes of the factor's columns. Buffers are kept.
#[derive(Default)]
pub(super) struct Tree {
    /// The tree as an upper triangle: each column lists its children. It has itself for elimination tree.
    pub ptr: Vec<u32>,
    pub idx: Vec<u32>,
    /// Entries of each column of the factor, diagonal included.
    pub counts: Vec<u32>,
    earlier_ptr: Vec<u32>,
    earlier: Vec<u32>,
    parent: Vec<u32>,
    /// The last row from which a walk came by.
    reached: Vec<u32>,
    /// Rows of later nodes in the columns of a node.
    below: Vec<u32>,
}

impl Tree {
    /// `start`: first unknown of every place and their number behind the last; `adj_ptr` and `adj`: later neighbours of every place.
    ///
    /// From every earlier neighbour of a node a walk goes up the tree until a node that this row has reached already; what it passes has
    /// the row in its columns (T. A. Davis, Algorithm 849, ACM Trans. Math. Softw. 31 (2005) 587-591).
    pub fn grow(&mut self, start: &[u32], adj_ptr: &[u32], adj: &[u32]) {
        let nodes = start.len() - 1;
        let Tree { ptr, idx, counts, earlier_ptr, earlier, parent, reached, below } = self;
        for (list, value) in [(&mut *parent, NONE), (&mut *reached, NONE), (&mut *below, 0)] {
            list.clear();
            list.resize(nodes, value);
        }
        let later = |node: usize| &adj[adj_ptr[node] as usize..adj_ptr[node + 1] as usize];
        let pairs = (0..nodes).flat_map(|node| later(node).iter().map(move |&row| (row, node as u32)));
        lists(nodes, pairs, earlier_ptr, earlier);
        for row in 0..nodes {
            reached[row] = row as u32;
            for &near in &earlier[earlier_ptr[row] as usize..earlier_ptr[row + 1] as usize] {
                let mut at = near as usize;
                while reached[at] != row as u32 {
                    if parent[at] == NONE {
                        parent[at] = row as u32;
                    }
                    below[at] += start[row + 1] - start[row];
                    reached[at] = row as u32;
                    at = parent[at] as usize;
                }
            }
        }
        counts.clear();
        for (node, below) in below.iter().enumerate() {
            let end = start[node + 1];
            counts.extend((start[node]..end).map(|dof| end - dof + below));
        }
        let edges = (0..nodes).flat_map(|node| {
            let (first, end, up) = (start[node], start[node + 1], parent[node]);
            let own = (first + 1..end).map(|dof| (dof, dof - 1));
            own.chain((up != NONE).then(|| (start[up as usize], end - 1)))
        });
        lists(start[nodes] as usize, edges, ptr, idx);
    }
}
