//! Supernodal Cholesky factor of faer on re-used buffers, sequential: candidates are solved in parallel outside.

use super::layout::{Layout, grown};
use faer::dyn_stack::MemBuffer;
use faer::linalg::cholesky::llt::factor::{LltParams, LltRegularization};
use faer::sparse::linalg::SymbolicSupernodalParams;
use faer::sparse::linalg::cholesky::{simplicial, supernodal};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Spec};

/// Factor and its buffers.
#[derive(Default)]
pub(super) struct Factor {
    symbolic: Option<supernodal::SymbolicSupernodalCholesky<u32>>,
    values: Vec<f64>,
    etree: Vec<i32>,
    scratch: Vec<u32>,
    stack: Option<(usize, MemBuffer)>,
    /// The last factorisation went through.
    positive: bool,
}

/// Supernodes are merged while the share of stored zeros stays below these (columns, share); node blocks of six make merging
/// of a few nodes worthwhile. Against no merging: a fifth more entries, a tenth less time on houses of 200 to 500 nodes.
const RELAX: [(usize, f64); 5] = [(8, 1.0), (24, 0.8), (72, 0.3), (200, 0.1), (usize::MAX, 0.03)];

/// Columns of the factor before which no pivot survived.
pub(super) struct NotPositive;

impl Factor {
    /// Elimination tree, supernodes and row lists of the pattern.
    pub fn analyse(&mut self, layout: &Layout) -> bool {
        let n = layout.n;
        self.etree.clear();
        self.etree.resize(n, 0);
        self.scratch.clear();
        self.scratch.resize(n, 0);
        let a = SymbolicSparseColMatRef::new_checked(n, n, &layout.upper_ptr, None, &layout.upper_idx);
        // The tree is known from the nodes. A matrix that is nothing but the tree has the same one, and is read in no time.
        let tree = SymbolicSparseColMatRef::new_checked(n, n, &layout.tree.ptr, None, &layout.tree.idx);
        let req = simplicial::prefactorize_symbolic_cholesky_scratch::<u32>(n, layout.tree.idx.len())
            .or(supernodal::factorize_supernodal_symbolic_cholesky_scratch::<u32>(n));
        let stack = grown(&mut self.stack, req);
        let etree = simplicial::prefactorize_symbolic_cholesky(&mut self.etree, &mut self.scratch, tree, stack);
        let params = SymbolicSupernodalParams { relax: Some(&RELAX) };
        self.positive = false;
        self.symbolic =
            supernodal::factorize_supernodal_symbolic_cholesky(a, etree, &layout.tree.counts, stack, params).ok();
        self.symbolic.is_some()
    }

    /// Numeric factor of the lower triangle `values` in `layout`'s pattern; [`Factor::analyse`] comes first.
    pub fn factorise(&mut self, layout: &Layout, values: &[f64]) -> Result<(), NotPositive> {
        let symbolic = self.symbolic.as_ref().ok_or(NotPositive)?;
        let n = layout.n;
        self.values.resize(symbolic.len_val(), 0.0);
        let pattern = SymbolicSparseColMatRef::new_checked(n, n, &layout.col_ptr, None, &layout.row_idx);
        let a = SparseColMatRef::new(pattern, values);
        let params = Spec::<LltParams, f64>::default();
        let req = supernodal::factorize_supernodal_numeric_llt_scratch::<u32, f64>(symbolic, Par::Seq, params);
        let stack = grown(&mut self.stack, req);
        let done = supernodal::factorize_supernodal_numeric_llt(
            &mut self.values,
            a,
            LltRegularization::default(),
            symbolic,
            Par::Seq,
            stack,
            params,
        );
        self.positive = done.is_ok();
        done.map(|_| ()).map_err(|_| NotPositive)
    }

    /// Whether the values are the factor of the matrix last given.
    pub fn is_usable(&self) -> bool {
        self.positive
    }

    /// What is kept is no factor of the frame.
    pub fn discard(&mut self) {
        self.positive = false;
    }

    /// Stored entries.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Bytes of the entries, their pattern and the scratch space.
    pub fn bytes(&self) -> usize {
        let rows = self.symbolic.as_ref().map_or(0, |s| s.row_idx().len() + 3 * s.n_supernodes());
        8 * self.values.len()
            + 4 * (rows + self.etree.len() + self.scratch.len())
            + self.stack.as_ref().map_or(0, |s| s.0)
    }

    /// Replaces the `columns` right-hand sides in `rhs` (column by column) by the solutions.
    pub fn solve(&mut self, rhs: &mut [f64], columns: usize) {
        let Some(symbolic) = self.symbolic.as_ref() else { return };
        if symbolic.nrows() == 0 || columns == 0 {
            return;
        }
        let stack = grown(&mut self.stack, symbolic.solve_in_place_scratch::<f64>(columns, Par::Seq));
        let view = MatMut::from_column_major_slice_mut(rhs, symbolic.nrows(), columns);
        supernodal::SupernodalLltRef::new(symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            view,
            Par::Seq,
            stack,
        );
    }

    /// Smallest pivot over its diagonal entry: the share of a dof's stiffness that elimination leaves.
    pub fn least_pivot(&self, layout: &Layout, values: &[f64]) -> f64 {
        let Some(symbolic) = self.symbolic.as_ref() else { return 0.0 };
        let l = supernodal::SupernodalLltRef::new(symbolic, &self.values);
        let mut least = 1.0f64;
        for s in 0..symbolic.n_supernodes() {
            let node = l.supernode(s);
            let (first, block) = (node.start(), node.val());
            for c in 0..block.ncols() {
                let pivot = block[(c, c)];
                least = least.min(pivot * pivot / values[layout.diagonal(first + c)]);
            }
        }
        least
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Material, Member, Model, Section};

    /// The tree and the counts found on the nodes are those of the pattern of all unknowns, for random graphs with random held dofs.
    #[test]
    fn the_tree_of_nodes_is_the_tree_of_unknowns() {
        let mut state = 7u64;
        let mut next = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % below as u64) as usize
        };
        for round in 0..200 {
            let nodes = 2 + next(40);
            let member = |nodes| Member {
                nodes,
                material: 0,
                section: 0,
                reference: None,
                roll: 0.0,
                releases: [[false; 6]; 2],
            };
            let model = Model {
                nodes: (0..nodes).map(|n| [n as f64, 0.0, 0.0]).collect(),
                materials: vec![Material { e: 1.0, g: 1.0, rho: 0.0 }],
                sections: vec![Section { a: 1.0, iy: 1.0, iz: 1.0, j: 1.0, asy: None, asz: None }],
                members: (0..nodes + next(2 * nodes)).map(|_| member([next(nodes), next(nodes)])).collect(),
                supports: Vec::new(),
                shear: false,
            };
            let active: Vec<[bool; 6]> = (0..nodes).map(|_| [0; 6].map(|_| next(3) > 0)).collect();
            let mut layout = Layout::default();
            layout.build(&model, &active).expect("a small frame");
            let n = layout.n;
            let (mut etree, mut counts) = (vec![0i32; n], vec![0u32; n]);
            let a = SymbolicSparseColMatRef::new_checked(n, n, &layout.upper_ptr, None, &layout.upper_idx);
            let req = simplicial::prefactorize_symbolic_cholesky_scratch::<u32>(n, layout.upper_idx.len());
            let mut stack = None;
            simplicial::prefactorize_symbolic_cholesky(&mut etree, &mut counts, a, grown(&mut stack, req));
            let mut factor = Factor::default();
            assert!(factor.analyse(&layout));
            assert_eq!(factor.etree, etree, "round {round}");
            assert_eq!(layout.tree.counts, counts, "round {round}");
        }
    }
}
