//! The buffers of the shaders.

/// A buffer, by its binding in the shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u32)]
pub(crate) enum Binding {
    Control = 0,
    Nodes = 1,
    CreaseStates = 2,
    Hinges = 3,
    Faces = 4,
    Slots = 5,
    Rows = 6,
    Corners = 7,
    LooseBeams = 8,
    Rigidities = 9,
    Partials = 10,
    Windows = 11,
    CheckpointNodes = 12,
    CheckpointAngles = 13,
    // Of the paper's five passes; 14 is where positions for pictures go.
    Settings = 15,
    RestNodes = 16,
    Motions = 17,
    NextVelocities = 18,
    Triangles = 19,
    FaceNormals = 20,
    Creases = 21,
    Springs = 22,
    BeamEnds = 23,
    Roles = 24,
    // Of blocks.
    Blocks = 25,
    Angles = 26,
    Targets = 27,
    Loads = 28,
    // Of contact.
    Pairs = 29,
    PairRows = 30,
    Nears = 31,
    Pushes = 32,
    Moves = 33,
    Shares = 34,
    Ways = 35,
    Touch = 36,
}

impl Binding {
    /// What the buffer holds, in words for error messages.
    pub(crate) fn what(self) -> &'static str {
        match self {
            Self::Control => "the control block",
            Self::Nodes => "the nodes",
            Self::CreaseStates => "the fold angles",
            Self::Hinges => "the creases",
            Self::Faces => "the triangles",
            Self::Slots => "the forces of the triangles",
            Self::Rows => "the rows of the nodes",
            Self::Corners => "the corner angles",
            Self::LooseBeams => "the loose beams",
            Self::Rigidities => "the rigidities of the beams",
            Self::Partials => "the partial sums",
            Self::Windows => "the stopping rule's memory",
            Self::CheckpointNodes => "the last good nodes",
            Self::CheckpointAngles => "the last good fold angles",
            Self::Settings => "the settings",
            Self::RestNodes => "the list of nodes",
            Self::Motions => "the motion of the nodes",
            Self::NextVelocities => "the next velocities of the nodes",
            Self::Triangles => "the list of triangles",
            Self::FaceNormals => "the normals of the triangles",
            Self::Creases => "the list of creases",
            Self::Springs => "the springs of the creases",
            Self::BeamEnds => "the list of beams at nodes",
            Self::Roles => "the list of creases and triangles at nodes",
            Self::Blocks => "the lists of the blocks",
            Self::Angles => "the fold angles in blocks",
            Self::Targets => "the target angles in blocks",
            Self::Loads => "the loads",
            Self::Pairs => "the pairs that may touch",
            Self::PairRows => "the rows of the pairs",
            Self::Nears => "the gaps of the pairs",
            Self::Pushes => "the forces of the pairs",
            Self::Moves => "the moves of the nodes",
            Self::Shares => "the shares of moves that pairs leave",
            Self::Ways => "the ways of the nodes",
            Self::Touch => "what contact does",
        }
    }
}
