// The keyboard: each key does what a button or a hand does.

export function keys(app) {
    addEventListener("keydown", (event) => {
        const typing = event.target.closest?.("input:not([type=range]), select, textarea, dialog[open]");
        const command = event.ctrlKey || event.metaKey;
        if (command && event.key.toLowerCase() === "z" && !typing) {
            event.preventDefault();
            return app.ask({ do: event.shiftKey ? "redo" : "undo" });
        }
        if (typing || command || event.altKey) return;
        if (event.key === " " && event.target.tagName !== "BUTTON") {
            event.preventDefault();
            return app.recording.now && app.live ? app.recording.play() : app.foldOrUnfold();
        }
        const does = {
            p: () => app.runOrPause(), s: () => app.step(), "0": () => app.reset(), o: () => app.files.chooseFile(), g: () => app.files.gallery(),
            e: () => app.files.exports(), "?": () => app.help(), "]": () => app.next(1), "[": () => app.next(-1), ",": () => app.recording.go(-1), ".": () => app.recording.go(1), Escape: () => app.choose(),
            h: () => app.setTool(app.tool === "grab" ? "turn" : "grab"), Home: () => app.look("corner"),
        };
        does[event.key]?.();
    });

    const turn = { ArrowLeft: [-14, 0], ArrowRight: [14, 0], ArrowUp: [0, -14], ArrowDown: [0, 14] };
    app.stage.canvas.addEventListener("keydown", (event) => {
        const { camera } = app.stage;
        if (turn[event.key]) event.shiftKey ? camera.pan(...turn[event.key]) : camera.orbit(...turn[event.key]);
        else if (event.key === "+" || event.key === "=") camera.zoomBy(1.15);
        else if (event.key === "-") camera.zoomBy(1 / 1.15);
        else return;
        event.preventDefault();
        app.stage.dirty = true;
    });
}
