//! Under construction.

pub mod triangulate;
