// What is known of the sheet: the pattern that was opened, and where its nodes are now.

export const LETTERS = { B: "border", M: "mountain", V: "valley", F: "flat", U: "undriven", J: "join", C: "cut" };

/** The pattern in a reply `opened`. */
export function opened({ head, buffer, at }) {
    const { nodes, triangles, edges } = head;
    const take = (Kind, count) => {
        const numbers = new Kind(buffer, at, count);
        at += 4 * count;
        return numbers;
    };
    const rest = take(Float32Array, 3 * nodes);
    const model = {
        ...head,
        rest,
        corners: take(Uint32Array, 3 * triangles),
        ends: take(Uint32Array, 2 * edges),
        angles: take(Float32Array, edges),
        faces: take(Uint32Array, triangles),
        points: new Float32Array(4 * nodes),
        size: 1,
    };
    for (let i = 0; i < nodes; i++) model.points.set(rest.subarray(3 * i, 3 * i + 3), 4 * i);
    for (let i = 0; i < rest.length; i++) model.size = Math.max(model.size, Math.abs(rest[i]));
    return model;
}

/** Whether an edge is a crease, which can have an angle of its own. */
export const isCrease = (model, edge) => model.letters[edge] !== "B" && model.ends[2 * edge] !== model.ends[2 * edge + 1];

/** For a person: `crease 12, mountain, -180°`. */
export function described(model, edge, wishes) {
    const own = wishes.creases[edge];
    const angle = model.angles[edge];
    const folds = own === "free" ? "free" : own ? `${number(own.angle)}° of its own`
        : Number.isNaN(angle) ? "no angle" : `${number(angle)}° at 100 %`;
    return `edge ${edge}, ${LETTERS[model.letters[edge]] ?? model.letters[edge]}, ${folds}`;
}

/** A number as short as it can be read. */
export function number(x, digits = 4) {
    if (x === null || x === undefined) return "–";
    return `${Number(x.toPrecision(digits))}`.replace("-", "−").replace(/e[+]?/, " e");
}
