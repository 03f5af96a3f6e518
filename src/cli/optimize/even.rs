//! An even sample of a sequence whose length is not known before.

/// Every so many-th of what is offered, never more than a given number.
pub struct EvenSample<T> {
    items: Vec<T>,
    offered: u64,
    every: u64,
    most: usize,
}

impl<T> EvenSample<T> {
    /// An empty sample of at most `most`.
    pub fn new(most: usize) -> Self {
        EvenSample { items: Vec::new(), offered: 0, every: 1, most }
    }

    /// Offers the next one; `item` is made only where its turn has come. Where there are too many, every second one is left out, and of
    /// what follows only half as many are taken.
    pub fn offer(&mut self, item: impl FnOnce() -> T) {
        if self.offered.is_multiple_of(self.every) {
            self.items.push(item());
        }
        self.offered += 1;
        if self.items.len() > self.most {
            let mut keep = false;
            self.items.retain(|_| {
                keep = !keep;
                keep
            });
            self.every *= 2;
        }
    }

    /// The sample, in the order of the sequence.
    pub fn items(&self) -> &[T] {
        &self.items
    }

    /// Number of all that were offered.
    pub fn offered(&self) -> u64 {
        self.offered
    }
}

#[cfg(test)]
mod tests {
    use super::EvenSample;

    #[test]
    fn a_sample_stays_even_and_small() {
        let mut sample = EvenSample::new(10);
        (0..1000).for_each(|n| sample.offer(|| n));
        let items = sample.items();
        let step = items[1] - items[0];
        assert!((5..=10).contains(&items.len()), "{items:?}");
        assert!(items.windows(2).all(|pair| pair[1] - pair[0] == step) && items[0] == 0, "{items:?}");
        assert!(1000 - items[items.len() - 1] <= step, "it reaches to the end: {items:?}");
        assert_eq!(sample.offered(), 1000);
    }
}
