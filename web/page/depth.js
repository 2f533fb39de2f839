// What lies in front of what, as shares of the depth of the screen's cube: the same however it is drawn.

/** Lines are in front of faces, marks in front of lines, dots of all. */
export const AHEAD = { lines: 1e-4, marks: 4e-4, dots: 2e-3 };

/** Faces that lie on each other keep one order, and do not flicker: they lie at so many depths, the last so far behind the first. */
export const DEPTHS = 32;
const BEHIND = 2e-5;
/** Neighbours mostly lie at one depth, which has so many groups of them. */
const GROUPS = 16;

export const behind = (depth) => (BEHIND * depth) / (DEPTHS - 1);

/** The depth of each triangle. */
export function depths(triangles) {
    const group = Math.max(1, Math.floor(triangles / (DEPTHS * GROUPS)));
    return Uint8Array.from({ length: triangles }, (_, triangle) => Math.floor(triangle / group) % DEPTHS);
}
