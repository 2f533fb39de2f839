//! `origami render` and the pictures of `origami fold`, in builds that draw and builds that do not.

#[cfg(not(feature = "render"))]
#[test]
fn a_build_without_pictures_says_so() {
    let place = crate::place::Place::new();
    for words in [
        "fold square.fold -o a.png",
        "fold square.fold --sheet a.png",
        "fold square.fold --animate a.gif --frames 2",
        "fold square.fold -o a.glb",
        "sweep square.fold -o out --folded png",
        "render square.fold -o a.svg",
    ] {
        let ran = place.run(words);
        ran.fails(1, "this build draws no pictures (feature `render`)");
        assert_eq!((ran.stdout.as_str(), place.names()), ("", vec!["square.fold".to_owned()]), "{words}");
    }
}

#[cfg(feature = "render")]
mod present {
    use serde_json::json;

    use crate::place::Place;

    /// A decoded PNG: of an animation the first picture.
    struct Png {
        width: u32,
        height: u32,
        /// Red, green, blue and alpha.
        pixels: Vec<[u8; 4]>,
        /// Pictures of an animation.
        frames: Option<u32>,
    }

    impl Png {
        fn corners(&self) -> [[u8; 4]; 4] {
            let (w, h) = (self.width as usize, self.height as usize);
            [0, w - 1, (h - 1) * w, h * w - 1].map(|i| self.pixels[i])
        }

        /// Share of pixels that are as the upper left one.
        fn ground(&self) -> f64 {
            let as_ground = self.pixels.iter().filter(|p| **p == self.pixels[0]).count();
            as_ground as f64 / self.pixels.len() as f64
        }

        /// How many different colours it has.
        fn colours(&self) -> usize {
            self.pixels.iter().collect::<std::collections::HashSet<_>>().len()
        }
    }

    fn png(bytes: &[u8]) -> Png {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::ALPHA);
        let mut reader = decoder.read_info().unwrap();
        let frames = reader.info().animation_control().map(|control| control.num_frames);
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        let pixels = bytes[..info.buffer_size()].chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect();
        Png { width: info.width, height: info.height, pixels, frames }
    }

    fn bytes(place: &Place, name: &str) -> Vec<u8> {
        std::fs::read(place.path(name)).unwrap()
    }

    fn picture(place: &Place, name: &str) -> Png {
        png(&bytes(place, name))
    }

    #[test]
    fn fold_draws_the_folded_sheet() {
        let place = Place::new();
        place.run("fold square.fold --percent 50 -o a.png --size 120x90 --samples 4 --report r.json").succeeds();
        let drawn = picture(&place, "a.png");
        assert_eq!((drawn.width, drawn.height), (120, 90));
        assert_eq!(drawn.corners(), [[255; 4]; 4], "white paper around it");
        assert!((0.2..0.9).contains(&drawn.ground()), "{} is ground", drawn.ground());
        assert!(drawn.colours() > 20, "two faces, three kinds of lines, and what is between them");
        let report = place.json("r.json");
        assert_eq!(report["outputs"], json!(["a.png"]));
        assert!(report["seconds"]["draw"].as_f64().unwrap() > 0.0);

        // The same by the other name, and the same again.
        place.run("fold square.fold --percent 50 --png b.png --size 120x90 --samples 4").succeeds();
        assert_eq!(bytes(&place, "a.png"), bytes(&place, "b.png"));
        // Another angle is another picture.
        place.run("fold square.fold --percent 90 --png b.png --size 120x90 --samples 4").succeeds();
        assert_ne!(bytes(&place, "a.png"), bytes(&place, "b.png"));
        // The default size.
        place.run("fold square.fold -o c.png --samples 1").succeeds();
        assert_eq!((picture(&place, "c.png").width, picture(&place, "c.png").height), (1000, 800));
    }

    #[test]
    fn each_option_changes_the_picture() {
        let place = Place::new();
        let draw = |options: &str| {
            place
                .run(&format!("fold square.fold --percent 50 -o a.png --size 200x160 --samples 4 {options}"))
                .succeeds();
            bytes(&place, "a.png")
        };
        let plain = draw("");
        let mut seen = vec![plain.clone()];
        for options in [
            "--camera top",
            "--camera front",
            "--camera isometric",
            "--azimuth 20",
            "--elevation 60",
            "--roll 30",
            "--zoom 0.5",
            "--perspective 60",
            "--theme white",
            "--theme mono",
            "--theme dark",
            "--background transparent",
            "--background #ffcc00",
            "--edges none",
            "--edges MVB",
            "--edges B",
            "--line-width 3",
            "--map angle-error --clip 1",
            "--map energy",
            "--strain --clip 0.001",
            "--strain --clip 0.001 --colours hue",
            "--strain --clip 0.001 --no-legend",
            "--caption Square",
        ] {
            let drawn = draw(options);
            // There is nothing else than mountains, valleys and boundaries in it.
            let same = options == "--edges MVB";
            assert_eq!(seen.contains(&drawn), same, "{options}");
            seen.push(drawn);
        }
        assert_eq!(draw("--camera default --theme paper --edges all --line-width 1 --zoom 1"), plain);
        assert_eq!(draw("--strain"), draw("--map strain"));
    }

    #[test]
    fn a_transparent_ground_is_that() {
        let place = Place::new();
        place.run("fold square.fold -o a.png --size 64x48 --samples 4 --background transparent").succeeds();
        let drawn = picture(&place, "a.png");
        assert!(drawn.corners().iter().all(|pixel| pixel[3] == 0), "{:?}", drawn.corners());
        assert!(drawn.pixels.iter().any(|pixel| pixel[3] == 255));
    }

    #[test]
    fn folders_take_pictures_of_many() {
        let place = Place::new();
        place.put("other.fold", &place.text("square.fold").replace("90]", "45]"));
        place.run("fold square.fold other.fold -o out/ --format png,svg --size 40x30 --quiet").succeeds();
        for name in ["out/square", "out/other"] {
            assert_eq!(picture(&place, &format!("{name}.png")).width, 40);
            assert!(place.text(&format!("{name}.svg")).ends_with("</svg>\n"));
        }
        assert_ne!(bytes(&place, "out/square.png"), bytes(&place, "out/other.png"));
        place.run("sweep square.fold --percent 0,50 -o sweep --folded png --quiet").succeeds();
        assert_ne!(bytes(&place, "sweep/0000.png"), bytes(&place, "sweep/0001.png"));
    }

    #[test]
    fn a_contact_sheet_has_the_pattern_and_all_stages() {
        let place = Place::new();
        // The pattern, the flat stage and four more: three beside each other.
        place.run("fold square.fold --sheet a.png --size 60x50 --samples 4").succeeds();
        let sheet = picture(&place, "a.png");
        assert_eq!((sheet.width, sheet.height), (180, 100));
        // Every part shows something.
        for (column, row) in (0..3).flat_map(|column| [(column, 0), (column, 1)]) {
            let inside = (0..60 * 50).map(|i| (row * 50 + i / 60) * 180 + column * 60 + i % 60);
            assert!(inside.filter(|i| sheet.pixels[*i] != [255; 4]).count() > 100, "part {column}, {row}");
        }
        // Stages of one's own choice; the FOLD file has what it would have without.
        place.run("fold square.fold --sheet a.png --size 200x150 --samples 1 --frames 2 --strain").succeeds();
        assert_eq!((picture(&place, "a.png").width, picture(&place, "a.png").height), (400, 300));
        place.run("fold square.fold --sheet a.png --size 60x50 --samples 1 -o a.fold").succeeds();
        assert_eq!(place.json("a.fold")["frame_classes"], json!(["foldedForm"]));
    }

    #[test]
    fn films_have_a_picture_for_each_stage() {
        let place = Place::new();
        let draw = |options: &str| {
            place
                .run(&format!("fold square.fold --size 50x40 --samples 1 --quiet --report r.json {options}"))
                .succeeds();
        };
        draw("--frames 3 --animate a.apng");
        let film = picture(&place, "a.apng");
        assert_eq!((film.width, film.height, film.frames), (50, 40, Some(4)));
        let gif_frames = || {
            let mut decoder =
                gif::DecodeOptions::new().read_info(std::fs::File::open(place.path("a.gif")).unwrap()).unwrap();
            let mut delays = Vec::new();
            while let Some(frame) = decoder.read_next_frame().unwrap() {
                delays.push(frame.delay);
            }
            delays
        };
        draw("--frames 3 --animate a.gif --fps 10");
        assert_eq!(gif_frames(), [10, 10, 10, 100], "a rest at the end");
        draw("--turntable 5 --animate a.gif");
        assert_eq!(gif_frames(), [5; 5], "the folded sheet alone, without a rest");
        draw("--turntable 5 --frames 2 --animate a.gif");
        assert_eq!(gif_frames().len(), 5, "it turns on when it is folded");
        draw("--turntable 2 --frames 6 --animate a.gif");
        assert_eq!(gif_frames().len(), 7, "it goes round more than once");

        std::fs::create_dir(place.path("film")).unwrap();
        draw("--frames 2 --animate film/a-.png");
        let files = ["film/a-000.png", "film/a-001.png", "film/a-002.png"];
        assert_eq!(place.json("r.json")["outputs"], json!(files));
        let pictures = files.map(|name| bytes(&place, name));
        assert!(pictures[0] != pictures[1] && pictures[1] != pictures[2]);
        // A whole round and a half one.
        draw("--turntable 4 --animate film/b-.png --camera top --no-legend");
        assert_eq!(place.json("r.json")["outputs"].as_array().unwrap().len(), 4);
        assert_ne!(bytes(&place, "film/b-000.png"), bytes(&place, "film/b-001.png"));
    }

    #[test]
    fn gltf_goes_through_the_frames() {
        let place = Place::new();
        let document = |options: &str| -> serde_json::Value {
            place.run(&format!("fold square.fold -o a.glb --quiet {options}")).succeeds();
            let file = bytes(&place, "a.glb");
            assert_eq!(
                (&file[..4], u32::from_le_bytes(file[8..12].try_into().unwrap()) as usize),
                (&b"glTF"[..], file.len())
            );
            let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
            serde_json::from_slice(&file[20..20 + length]).unwrap()
        };
        let still = document("");
        assert!(still.get("animations").is_none_or(|animations| animations == &json!([])));
        let film = document("--frames 3");
        assert_eq!(film["animations"].as_array().unwrap().len(), 1);
        assert_eq!(film["meshes"][0]["primitives"][0]["targets"].as_array().unwrap().len(), 3);
        assert_eq!(film["meshes"][0]["primitives"][0]["attributes"].get("COLOR_0"), None);
        assert_ne!(document("--strain")["meshes"][0]["primitives"][0]["attributes"].get("COLOR_0"), None);
    }

    #[test]
    fn render_draws_a_pattern_and_a_folded_form() {
        let place = Place::new();
        let ran = place.run("render square.fold -o a.png -o a.svg --size 80x60 --samples 4");
        assert!(ran.succeeds().starts_with("square.fold: frame 0 drawn as a.png, a.svg, "), "{}", ran.stdout);
        assert_eq!(picture(&place, "a.png").width, 80);
        assert!(place.text("a.svg").contains("id=\"valley\""), "{}", place.text("a.svg"));
        // From the side and as a sheet it is another picture.
        place.run("render square.fold -o b.png --view sheet --size 80x60 --samples 4 --quiet").succeeds();
        assert_ne!(bytes(&place, "a.png"), bytes(&place, "b.png"));

        // What `fold` draws and what `render` draws of its file are one picture.
        let look = "--size 200x150 --samples 4 --quiet";
        place.run(&format!("fold square.fold --frames 2 -o film.fold -o a.png {look}")).succeeds();
        place.run(&format!("render film.fold --frame 3 -o b.png {look}")).succeeds();
        let (one, other) = (picture(&place, "a.png"), picture(&place, "b.png"));
        let apart = one.pixels.iter().zip(&other.pixels).filter(|(a, b)| a != b).count();
        assert!(apart < one.pixels.len() / 200, "{apart} pixels differ");
        for map in ["strain", "face-strain", "angle-error", "energy"] {
            place.run(&format!("render film.fold --frame 2 --map {map} -o c.png {look}")).succeeds();
            assert_ne!(bytes(&place, "b.png"), bytes(&place, "c.png"));
        }
        place.run(&format!("render film.fold --frame 3 -o b.glb {look}")).succeeds();
        assert_eq!(&bytes(&place, "b.glb")[..4], b"glTF");
    }

    /// Without an adapter there is nothing to hold against; the tests of `--backend gpu` say so.
    #[cfg(feature = "gpu")]
    #[test]
    fn a_gpu_draws_the_same_to_what_an_eye_can_tell() {
        let place = Place::new();
        if place.run("adapters --json").stdout.trim() == "[]" {
            return;
        }
        let look = "--view sheet --size 160x120 --quiet";
        place.run(&format!("render square.fold -o a.png --backend gpu {look}")).succeeds();
        place.run(&format!("render square.fold -o b.png {look}")).succeeds();
        let (one, other) = (picture(&place, "a.png"), picture(&place, "b.png"));
        let apart = |(a, b): (&[u8; 4], &[u8; 4])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 48);
        let count = one.pixels.iter().zip(&other.pixels).filter(|pair| apart(*pair)).count();
        assert!(one.colours() > 20 && count < one.pixels.len() / 50, "{count} pixels differ");
    }

    #[test]
    fn a_picture_goes_to_standard_output() {
        let place = Place::new();
        let mut command = place.command();
        let command = command.args("render - -o - --size 30x20".split(' ')).write_stdin(place.text("square.fold"));
        let output = command.output().unwrap();
        assert_eq!((png(&output.stdout).width, output.status.code()), (30, Some(0)));
        assert!(String::from_utf8(output.stderr).unwrap().starts_with("-: frame 0 drawn as -, "));
    }

    #[test]
    fn what_cannot_be_drawn_is_refused_and_leaves_nothing() {
        let place = Place::new();
        for (words, expected) in [
            (
                "fold square.fold -o a.png --size 20000x10",
                "20000 x 10 pixels are too many; expected at most 16384 a side",
            ),
            ("fold square.fold -o a.png --size 16000x16000", "100 million in all"),
            ("fold square.fold -o a.png --background blue-ish", "expected `transparent`, `white`, `black` or a colour"),
            ("fold square.fold -o a.png --edges XY", "expected letters of MVBFCU, `all` or `none`"),
            ("fold square.fold -o a.png --perspective 170", "5 to 120 degrees"),
            ("fold square.fold -o a.png --zoom 1e9", "0.001 to 1000"),
            ("fold square.fold --sheet a.png --frames 600", "--sheet: "),
            ("fold square.fold --sheet a.gif", "a.gif: expected a path ending in .png for --sheet"),
            ("fold square.fold --animate a.mp4 --frames 3", "a.mp4: no film is written as this"),
            ("fold square.fold --animate film/a.gif --frames 2", "there is no folder film"),
            ("fold square.fold other.fold --sheet a.png", "--sheet takes one input"),
            ("fold square.fold -o a.png --sheet ./a.png", "is named twice"),
            (
                "render square.fold -o a.png --strain",
                "square.fold: frame 0: a crease pattern as it lies has nothing to map",
            ),
            ("render square.fold -o a.png --strain --view sheet", "frame 0: does not tell how long its edges were"),
            ("render square.fold -o a.png --frame 7", "frame 7: there is no such frame"),
            ("render missing.fold -o a.png", "missing.fold"),
            ("render square.fold -o a.png -o ./a.png", "is named twice"),
        ] {
            let ran = place.run(words);
            ran.fails(1, expected);
            assert_eq!((ran.stdout.as_str(), place.names()), ("", vec!["square.fold".to_owned()]), "{words}");
        }
        // A folded form is no crease pattern, and says nothing of how it was before.
        place.run("fold square.fold -o folded.fold --quiet").succeeds();
        place.run("render folded.fold -o a.svg").fails(1, "the sheet is not flat");
        place.run("render folded.fold -o a.png --strain").fails(1, "expected a frame that inherits from its crease");
        assert!(!place.has("a.svg") && !place.has("a.png"));
    }

    #[test]
    fn options_of_pictures_without_one_are_told() {
        let place = Place::new();
        let ran = place.run("fold square.fold -o a.fold --strain");
        assert_eq!(ran.stderr, "warning: options of pictures have no effect: none is asked for\n");
        let ran = place.run("fold square.fold -o a.png --size 20x20 --colours hue");
        assert_eq!(ran.stderr, "warning: --colours has no effect without --map or --strain\n");
    }

    #[test]
    fn a_sheet_that_diverged_is_not_drawn() {
        let place = Place::new();
        let ran = place.run("fold square.fold --solver dynamics --time-step 50 --ea 1e6 -o a.png");
        assert_eq!((ran.code, place.has("a.png")), (2, false));
    }
}
