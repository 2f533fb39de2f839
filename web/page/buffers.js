// What WebGL keeps of a sheet: its nodes once, and of all that is drawn which of them are its corners.

/** The largest number of 16 bits, which as a node means none. */
const NONE = 0xffff;

/** Where the nodes are: x, y, z and a value of each. */
export class Nodes {
    constructor(gl, count) {
        Object.assign(this, { gl, count, buffer: gl.createBuffer() });
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
        gl.bufferData(gl.ARRAY_BUFFER, 16 * count, gl.DYNAMIC_DRAW);
    }

    write(points) {
        this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffer);
        this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, points);
    }

    /** Triangles, thin lines or dots by their nodes, in parts of which each is drawn in its own way. */
    parts(lists) {
        const corners = (this.count > NONE ? Uint32Array : Uint16Array).from(lists.flatMap((list) => [...list]));
        return new Parts(this.gl, corners, lists.map((list) => list.length), () => {
            this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffer);
            attribute(this.gl, 0, 4, 16, 0);
        });
    }

    drop() {
        this.gl.deleteBuffer(this.buffer);
    }
}

/** Wide lines: both ends of each at its four corners, which the shader moves apart. Parts as those of `Nodes`. */
export class Strokes {
    constructor(gl, lists) {
        this.gl = gl;
        this.ends = Uint32Array.from(lists.flatMap((list) => [...list]));
        const lines = this.ends.length / 2;
        this.places = new Float32Array(24 * lines);
        this.buffer = gl.createBuffer();
        const corners = new Uint32Array(6 * lines);
        for (let line = 0; line < lines; line++) corners.set([0, 1, 2, 2, 1, 3].map((corner) => 4 * line + corner), 6 * line);
        this.lines = new Parts(gl, corners, lists.map((list) => 3 * list.length), () => {
            gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
            gl.bufferData(gl.ARRAY_BUFFER, this.places.byteLength, gl.DYNAMIC_DRAW);
            attribute(gl, 0, 3, 24, 0);
            attribute(gl, 1, 3, 24, 12);
        });
    }

    write(points) {
        const { gl, ends, places } = this;
        for (let i = 0, at = 0; i < ends.length; i += 2) {
            const [a, b] = [4 * ends[i], 4 * ends[i + 1]];
            for (let corner = 0; corner < 4; corner++) {
                for (let k = 0; k < 3; k++) {
                    places[at + k] = points[a + k];
                    places[at + 3 + k] = points[b + k];
                }
                at += 6;
            }
        }
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
        gl.bufferSubData(gl.ARRAY_BUFFER, 0, places);
    }

    draw(kind, begin) {
        this.lines.draw(kind, begin);
    }

    drop() {
        this.lines.drop();
        this.gl.deleteBuffer(this.buffer);
    }
}

class Parts {
    constructor(gl, corners, counts, attributes) {
        Object.assign(this, { gl, counts, size: corners.BYTES_PER_ELEMENT, array: gl.createVertexArray(), buffer: gl.createBuffer() });
        gl.bindVertexArray(this.array);
        attributes();
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.buffer);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, corners, gl.STATIC_DRAW);
        gl.bindVertexArray(null);
    }

    /** Draws the parts, of each of which `begin` is told the number; not those where it says false. */
    draw(kind, begin) {
        const { gl, size } = this;
        const number = size === 2 ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
        gl.bindVertexArray(this.array);
        let first = 0;
        this.counts.forEach((count, part) => {
            if (count && begin(part) !== false) gl.drawElements(kind, count, number, first);
            first += size * count;
        });
        gl.bindVertexArray(null);
    }

    drop() {
        this.gl.deleteVertexArray(this.array);
        this.gl.deleteBuffer(this.buffer);
    }
}

function attribute(gl, at, size, stride, offset) {
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, gl.FLOAT, false, stride, offset);
}
