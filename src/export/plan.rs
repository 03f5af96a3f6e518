//! Storey plans.
