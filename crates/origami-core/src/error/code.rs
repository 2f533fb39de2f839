//! The kinds of errors and warnings, by names that stay the same from one release to the next.

use std::fmt;

macro_rules! codes {
    ($(#[$doc:meta])* $codes:ident { $($(#[$of_one:meta])* $code:ident = $name:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $codes {
            $($(#[$of_one])* $code,)*
        }

        impl $codes {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$code),*];

            /// The name in reports, in words joined by hyphens. It does not change.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$code => $name,)*
                }
            }
        }

        impl fmt::Display for $codes {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.pad(self.name())
            }
        }
    };
}

codes! {
    /// The kind of an [`Error`](super::Error).
    ErrorCode {
        /// The operating system refused to read or write.
        Io = "io",
        /// The file is not text in UTF-8.
        NotUtf8 = "not-utf8",
        /// The file holds nothing but white space.
        EmptyFile = "empty-file",
        /// The text breaks the rules of JSON.
        NotJson = "not-json",
        /// The text breaks the rules of XML.
        NotXml = "not-xml",
        /// The file is something else than a crease pattern.
        NotAPattern = "not-a-pattern",
        /// The file, or what comes out of a compressed one, is larger than any pattern.
        InputTooLarge = "input-too-large",
        /// A compressed file is damaged or cut off.
        Damaged = "damaged",
        /// A drawing without a line that stands for a border or a crease.
        NoLines = "no-lines",
        /// A value is of another type than its key has, such as a text in place of a number.
        WrongType = "wrong-type",
        /// An object has the same key twice.
        KeyTwice = "key-twice",
        /// A number is beyond the range of 64-bit floats.
        NumberTooLarge = "number-too-large",
        /// Arrays or objects are nested too deeply to be read.
        NestedTooDeeply = "nested-too-deeply",
        /// The file has no frame of this number.
        NoSuchFrame = "no-such-frame",
        /// A frame inherits from itself, at once or by way of others.
        FramesInACircle = "frames-in-a-circle",
        /// A key that is needed is missing or has an empty array.
        MissingKey = "missing-key",
        /// An array has more or fewer entries than the one it goes with.
        WrongLength = "wrong-length",
        /// An array has more entries than can be numbered.
        TooManyEntries = "too-many-entries",
        /// A value is of the right type and out of its range.
        WrongValue = "wrong-value",
        /// A coordinate or an angle is infinite or not a number.
        NotFinite = "not-finite",
        /// An edge, a face or a triangle names a vertex that does not exist.
        NoSuchVertex = "no-such-vertex",
        /// All vertices lie at one point, or the sheet is too small or too large to compute with.
        SheetSize = "sheet-size",
        /// The two ends of an edge or of a face's side are one vertex or lie at one point.
        EdgeWithoutLength = "edge-without-length",
        /// Two edges lie between the same vertices and neither is an alias of the other.
        EdgeTwice = "edge-twice",
        /// More than two faces meet at an edge, or two lie on the same side of it.
        EdgeOfManyFaces = "edge-of-many-faces",
        /// The faces cannot be turned to agree on which side is up, as on a Moebius strip.
        OneSided = "one-sided",
        /// A face has fewer than three different corners.
        FaceOfFewCorners = "face-of-few-corners",
        /// A face names one corner twice in a row.
        CornerTwice = "corner-twice",
        /// A face runs to and fro along a line and encloses nothing.
        FaceWithoutArea = "face-without-area",
        /// A face crosses itself, or touches itself between corners.
        FaceNotSimple = "face-not-simple",
        /// The lines enclose no paper, and the file gives no faces.
        NoPaper = "no-paper",
        /// The border does not close, and there is no one way to close it.
        BorderOpen = "border-open",
        /// Lines cross so often that they cannot be told apart.
        LinesTooDense = "lines-too-dense",
        /// A setting or an argument of a call is out of range.
        Setting = "setting",
    }
}

codes! {
    /// The kind of a [`Warning`](super::Warning): to mute one kind, or to treat it as an error.
    WarningCode {
        /// A part of the file that is no line of the pattern, or a property of a line, was left out.
        LeftOut = "left-out",
        /// The file's name says another format than its content.
        OtherFormat = "other-format",
        /// Numbers written in another way than the format has, such as with decimal commas.
        OddNumber = "odd-number",
        /// A colour that was taken for another one, or dashes that were taken for colours.
        Colour = "colour",
        /// A key by its name in FOLD 1.0.
        OldKey = "old-key",
        /// `frame_inherit` in the key frame, which has no parent.
        KeyFrameInherits = "key-frame-inherits",
        /// A frame that inherits and names no parent.
        NoParent = "no-parent",
        /// Some vertices have two coordinates and some three.
        MixedDimensions = "mixed-dimensions",
        /// Vertices so near each other that they were merged.
        VerticesMerged = "vertices-merged",
        /// A vertex that belongs to no edge and no face.
        IsolatedVertex = "isolated-vertex",
        /// A vertex lies on a line, which was split there.
        VertexOnEdge = "vertex-on-edge",
        /// Two lines cross, and both got a vertex there.
        EdgesCross = "edges-cross",
        /// An edge whose ends were merged.
        EdgeWithoutLength = "edge-without-length",
        /// One line is given more than once.
        EdgeTwice = "edge-twice",
        /// One line is given more than once, with different letters.
        EdgeTwiceLetters = "edge-twice-letters",
        /// An edge that belongs to no face.
        EdgeOutside = "edge-outside",
        /// A side of a face that `edges_vertices` does not list.
        UnlistedSide = "unlisted-side",
        /// No faces: they were built from the lines.
        FacesBuilt = "faces-built",
        /// A face that was turned over to agree with its neighbours.
        FaceTurned = "face-turned",
        /// A face that is seen from its back.
        FaceClockwise = "face-clockwise",
        /// A face without area.
        FaceWithoutArea = "face-without-area",
        /// A face too thin for springs.
        ThinFace = "thin-face",
        /// No letters: they were derived, or nothing folds.
        MissingLetters = "missing-letters",
        /// No fold angles: they follow from letters or coordinates.
        MissingAngles = "missing-angles",
        /// The sheet is flat in a tilted plane: its coordinates say nothing of angles.
        TiltedPlane = "tilted-plane",
        /// A letter in lower case.
        LowerCase = "lower-case",
        /// A letter that FOLD does not know.
        UnknownLetter = "unknown-letter",
        /// A letter other than `B` on the contour.
        LetterOnContour = "letter-on-contour",
        /// `B` between two faces of the file.
        BoundaryInside = "boundary-inside",
        /// `B` with paper on both sides: the sheet is cut there.
        BoundaryCut = "boundary-cut",
        /// A cut both of whose ends lie inside the sheet, so that it cannot open.
        ClosedCut = "closed-cut",
        /// A fold angle on a boundary or cut.
        AngleOnBoundary = "angle-on-boundary",
        /// A mountain or valley whose fold angle is `null`.
        NullAngle = "null-angle",
        /// An unassigned edge with a fold angle.
        AngleOnUnassigned = "angle-on-unassigned",
        /// A flat edge with a fold angle.
        AngleOnFlat = "angle-on-flat",
        /// A fold angle past 180 degrees.
        AnglePastFlat = "angle-past-flat",
        /// A letter and a fold angle of opposite signs.
        OppositeSigns = "opposite-signs",
        /// Creases that are asked to fold past 180 degrees.
        OverFolding = "over-folding",
        /// Triangles that are nearly lines.
        Slivers = "slivers",
        /// Lips of cuts that contact does not keep apart.
        TouchingLips = "touching-lips",
        /// Creases too soft for single precision.
        SinglePrecision = "single-precision",
        /// A sheet that came to rest strained.
        StrainedAtRest = "strained-at-rest",
        /// A sheet that came to rest with a crease far from its angle: at 100 % without strain, at any other percentage very far.
        CreaseOffTarget = "crease-off-target",
        /// A crease that ends inside a face, and is far from its angle for it.
        OpenCrease = "open-crease",
        /// Triangles that were crushed to a line while the sheet was folded.
        CrushedTriangle = "crushed-triangle",
        /// Triangles that are kept from being crushed by springs that the paper does not have.
        SqueezedTriangle = "squeezed-triangle",
        /// Something that was asked for is not to be had, and something else was taken.
        Fallback = "fallback",
        /// An end that came near a line or another end, and was joined to it.
        NearMissJoined = "near-miss-joined",
        /// As `near-miss-joined`, where the border ends: the outline of the sheet has changed.
        BorderJoined = "border-joined",
        /// The border was open, and was closed by a straight line.
        BorderClosed = "border-closed",
        /// Lines lie outside all faces: there may have been paper.
        PaperLost = "paper-lost",
        /// Faces of the file contradict its lines; they were found anew.
        FacesRepaired = "faces-repaired",
        /// A crease lies in a hole of the sheet.
        CreaseInHole = "crease-in-hole",
        /// An end that comes near a line or another end, not near enough to be joined to it.
        NearMiss = "near-miss",
        /// Fold angles that may be in radians.
        Radians = "radians",
        /// A key that FOLD does not have and that is nearly one that it has.
        UnknownKey = "unknown-key",
        /// The frame that was taken is a folded form, and another one is a crease pattern.
        OtherFrame = "other-frame",
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// The names that are no words joined by hyphens, or that come twice.
    fn odd<'n>(names: impl IntoIterator<Item = &'n str>) -> Vec<&'n str> {
        let word = |w: &str| !w.is_empty() && w.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit());
        let mut seen = BTreeSet::new();
        names.into_iter().filter(|name| !name.split('-').all(word) || !seen.insert(*name)).collect()
    }

    #[test]
    fn names_are_kebab_case_and_unique() {
        assert_eq!(odd(ErrorCode::ALL.iter().map(|code| code.name())), [""; 0]);
        assert_eq!(odd(WarningCode::ALL.iter().map(|code| code.name())), [""; 0]);
        assert_eq!(odd(["a", "a-b", "a", "A", "a_b", "-a", ""]), ["a", "A", "a_b", "-a", ""], "the check can fail");
    }

    /// Scripts mute and count warnings by name: one that is renamed here breaks them.
    #[test]
    fn names_stay() {
        let names = |codes: &[&'static str]| codes.join(" ");
        let errors: Vec<&str> = ErrorCode::ALL.iter().map(|code| code.name()).collect();
        assert_eq!(
            names(&errors),
            "io not-utf8 empty-file not-json not-xml not-a-pattern input-too-large damaged no-lines wrong-type key-twice \
             number-too-large nested-too-deeply no-such-frame frames-in-a-circle missing-key wrong-length \
             too-many-entries wrong-value not-finite no-such-vertex sheet-size \
             edge-without-length edge-twice edge-of-many-faces one-sided face-of-few-corners corner-twice \
             face-without-area face-not-simple no-paper border-open lines-too-dense setting"
        );
        let warnings: Vec<&str> = WarningCode::ALL.iter().map(|code| code.name()).collect();
        assert_eq!(
            names(&warnings),
            "left-out other-format odd-number colour old-key key-frame-inherits no-parent mixed-dimensions \
             vertices-merged isolated-vertex vertex-on-edge \
             edges-cross edge-without-length edge-twice edge-twice-letters edge-outside unlisted-side faces-built \
             face-turned face-clockwise face-without-area thin-face missing-letters missing-angles tilted-plane \
             lower-case unknown-letter letter-on-contour boundary-inside boundary-cut closed-cut angle-on-boundary \
             null-angle angle-on-unassigned angle-on-flat angle-past-flat opposite-signs over-folding slivers \
             touching-lips single-precision strained-at-rest crease-off-target open-crease crushed-triangle squeezed-triangle fallback near-miss-joined border-joined \
             border-closed paper-lost faces-repaired crease-in-hole near-miss radians unknown-key other-frame"
        );
    }
}
