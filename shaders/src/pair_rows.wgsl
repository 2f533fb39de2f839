// Where the nodes find what pairs do to them: the first slot of each, and the end of the last.

@group(0) @binding(30) var<storage, read> pair_rows: array<u32>;
