//! Typed indices. `u32` inside: half the memory of `usize`, and what a GPU wants.

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[repr(transparent)]
        pub struct $name(pub u32);

        impl $name {
            /// The id of the element at `index` of its array.
            ///
            /// # Panics
            /// If `index` does not fit in `u32`; readers refuse files of that size.
            #[must_use]
            pub fn new(index: usize) -> Self {
                Self(u32::try_from(index).expect("more than 2^32 elements"))
            }

            /// The index in an array.
            #[must_use]
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

ids! {
    /// A vertex of the crease pattern; the first ones are numbered as in the file.
    VertexId,
    /// An edge of the crease pattern; the first ones are numbered as in the file.
    EdgeId,
    /// A face of the crease pattern, a polygon.
    FaceId,
    /// A node of the triangulated sheet, the end of beams.
    NodeId,
    /// A side of the triangulation; each is a beam.
    SideId,
    /// A triangle of the triangulated sheet.
    TriangleId,
    /// A crease that has a spring: its index in [`Model::creases`](crate::Model::creases).
    CreaseId,
}
