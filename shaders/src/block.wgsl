// Where a block finds its part of the sheet. A workgroup has some nodes of its own, which it moves, and reads what pulls at
// them: their triangles, the creases on the sides of these, and the nodes of both. Positions, moments and forces lie in its
// memory, and what lies on the border of two blocks is computed by either. Here all indices are those in the block.

// What `blocks` begins with for each block: how many there are of each, and the words at which their lists begin.
struct Block {
    own: u32,
    nodes: u32,
    creases: u32,
    faces: u32,
    loose: u32,
    // Of the fold angles and targets of this block.
    first_crease: u32,
    // A word each: the index in the sheet; first those of its own.
    at_nodes: u32,
    // Three words a side, creases first: ends and apexes, kind and square at rest in two parts.
    at_sides: u32,
    // Three words a triangle: nodes and flags, sides, twice the area at rest.
    at_faces: u32,
    // A word each of its own nodes: first and last of its entries; half a word an entry: a slot.
    at_rows: u32,
    at_entries: u32,
    // Four words a loose beam: ends, square at rest in two parts, rigidity.
    at_loose: u32,
    // A word a crease, and a word a side, where they have their own.
    at_stiffness: u32,
    at_rigidities: u32,
}

const HEADER: u32 = 16u;

override POSITION_WORDS: u32;
override MOMENTS: u32;
override FORCE_WORDS: u32;

var<private> block: Block;
var<workgroup> highs: array<i32, POSITION_WORDS>;
var<workgroup> lows: array<f32, POSITION_WORDS>;
var<workgroup> moments: array<f32, MOMENTS>;
// Three words a slot.
var<workgroup> forces: array<f32, FORCE_WORDS>;

fn open_block(b: u32) {
    let h = b * HEADER;
    block = Block(
        word(h), word(h + 1u), word(h + 2u), word(h + 3u), word(h + 4u), word(h + 5u), word(h + 6u),
        word(h + 7u), word(h + 8u), word(h + 9u), word(h + 10u), word(h + 11u), word(h + 12u), word(h + 13u),
    );
}

// The index of a node in the sheet.
fn in_sheet(n: u32) -> u32 {
    return word(block.at_nodes + n);
}

fn put_position(n: u32, position: SplitVector) {
    for (var i = 0u; i < 3u; i++) {
        highs[3u * n + i] = position.high[i];
        lows[3u * n + i] = position.low[i];
    }
}

fn position_at(instance: u32, n: u32) -> SplitVector {
    let i = 3u * n;
    return SplitVector(
        vec3<i32>(highs[i], highs[i + 1u], highs[i + 2u]),
        vec3<f32>(lows[i], lows[i + 1u], lows[i + 2u]),
    );
}

// Byte `i` of a word.
fn byte(w: u32, i: u32) -> u32 {
    return (w >> (8u * i)) & 0xffu;
}

fn rest_high_of(side: u32) -> i32 {
    return i32(word(block.at_sides + 3u * side + 1u) & 0x3fffffffu);
}

fn rest_low_of(side: u32) -> f32 {
    return bitcast<f32>(word(block.at_sides + 3u * side + 2u));
}

fn hinge_at(c: u32) -> Hinge {
    let w = word(block.at_sides + 3u * c);
    let kind = word(block.at_sides + 3u * c + 1u) >> 30u;
    var length: f32;
    if (kind == FOLD || kind == FACET) {
        length = rest_length(rest_high_of(c), rest_low_of(c));
    } else {
        length = bitcast<f32>(word(block.at_stiffness + c));
    }
    return Hinge(byte(w, 2u), byte(w, 3u), byte(w, 0u), byte(w, 1u), length, kind);
}

fn face_at(f: u32) -> Face {
    let w = word(block.at_faces + 3u * f);
    let packed = word(block.at_faces + 3u * f + 1u);
    var face: Face;
    for (var i = 0u; i < 3u; i++) {
        let side = (packed >> (10u * i)) & 0x3ffu;
        let flags = select(0u, ALONE, ((w >> (24u + i)) & 1u) != 0u) | select(0u, RIGHT, ((w >> (27u + i)) & 1u) != 0u);
        face.nodes[i] = byte(w, i);
        face.slots[i] = 3u * f + i;
        face.sides[i] = select(CREASE, side, side < block.creases) | flags;
        face.rest_high[i] = rest_high_of(side);
        face.rest_low[i] = rest_low_of(side);
    }
    return face;
}

fn loose_at(l: u32) -> LooseBeam {
    let at = block.at_loose + 4u * l;
    let slot = 3u * block.faces + 2u * l;
    return LooseBeam(
        array<u32, 2>(byte(word(at), 0u), byte(word(at), 1u)),
        array<u32, 2>(slot, slot + 1u),
        i32(word(at + 1u)),
        bitcast<f32>(word(at + 2u)),
        bitcast<f32>(word(at + 3u)),
    );
}

fn put_moment(instance: u32, c: u32, moment: f32) {
    moments[c] = moment;
}

fn moment_at(instance: u32, c: u32) -> f32 {
    return moments[c];
}

fn put_force(instance: u32, slot: u32, force: vec3<f32>) {
    let i = 3u * slot;
    forces[i] = force.x;
    forces[i + 1u] = force.y;
    forces[i + 2u] = force.z;
}

fn force_in(slot: u32) -> vec3<f32> {
    return vec3<f32>(forces[3u * slot], forces[3u * slot + 1u], forces[3u * slot + 2u]);
}

// Row sums take the place of forces that have been summed.
fn put_row_sum(instance: u32, slot: u32, sum: f32) {
    forces[slot] = sum;
}

// First and last entry of a node of its own.
fn entries_of(n: u32) -> vec2<u32> {
    let row = word(block.at_rows + n);
    return vec2<u32>(row & 0xffffu, row >> 16u);
}

fn slot_of(entry: u32) -> u32 {
    return (word(block.at_entries + entry / 2u) >> (16u * (entry & 1u))) & 0xffffu;
}

// The springs' forces on a node of its own, summed in fixed order.
fn summed_force(n: u32) -> vec3<f32> {
    let entries = entries_of(n);
    var sum = vec3<f32>(0.0);
    for (var e = entries.x; e < entries.y; e++) {
        sum += force_in(slot_of(e));
    }
    return sum;
}

fn summed_row(n: u32) -> f32 {
    let entries = entries_of(n);
    var sum = 0.0;
    for (var e = entries.x; e < entries.y; e++) {
        sum += forces[slot_of(e)];
    }
    return sum;
}
