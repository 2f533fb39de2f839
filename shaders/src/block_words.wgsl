// The lists of the blocks, which never change.

@group(0) @binding(25) var<storage, read> blocks: array<u32>;

fn word(i: u32) -> u32 {
    return blocks[i];
}
