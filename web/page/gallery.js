// Patterns to begin with: what the program can generate, each with its picture.

import { css, lineOf, theme } from "./colours.js";

/** Fills the dialog; `choose` gets a name. */
export function fill(list, entries, choose) {
    const colours = theme(list);
    list.replaceChildren(...entries.map((entry) => {
        const button = document.createElement("button");
        button.className = "card";
        button.dataset.pattern = entry.name;
        const name = document.createElement("b");
        name.textContent = entry.name.replaceAll("-", " ");
        const summary = document.createElement("span");
        summary.textContent = entry.summary;
        button.append(picture(entry.picture, colours), name, summary);
        button.onclick = () => choose(entry.name);
        return button;
    }));
}

/** The crease pattern as SVG. */
function picture({ points, ends, letters }, colours) {
    const space = "http://www.w3.org/2000/svg";
    const svg = document.createElementNS(space, "svg");
    const [xs, ys] = [0, 1].map((axis) => points.filter((_, i) => i % 2 === axis));
    const [x, y] = [Math.min(...xs), Math.min(...ys)];
    const [width, height] = [Math.max(...xs) - x, Math.max(...ys) - y];
    const size = Math.max(width, height) || 1;
    svg.setAttribute("viewBox", `${x + width / 2 - size * 0.54} ${-y - height / 2 - size * 0.54} ${size * 1.08} ${size * 1.08}`);
    svg.setAttribute("aria-hidden", "true");
    for (const letter of new Set([...letters].sort((a, b) => (a === "B") - (b === "B")))) {
        const path = document.createElementNS(space, "path");
        const lines = [...letters].flatMap((own, edge) => (own === letter ? [edge] : [])).map((edge) => {
            const [a, b] = [ends[2 * edge], ends[2 * edge + 1]];
            return `M${points[2 * a]} ${-points[2 * a + 1]}L${points[2 * b]} ${-points[2 * b + 1]}`;
        });
        path.setAttribute("d", lines.join(""));
        path.setAttribute("stroke", css(colours[lineOf(letter)]));
        path.setAttribute("stroke-width", size / (letter === "B" ? 55 : 75));
        path.setAttribute("stroke-linecap", "round");
        svg.append(path);
    }
    return svg;
}
