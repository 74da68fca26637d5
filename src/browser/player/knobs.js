// The knobs as rows: each shows a key of the scene, of one book, and changes it. The core says which models have the key, its unit and
// whether it is whole; a knob without `get` is shown where the scene has a value.

const sizeKnob = (axis, label) => ({
  group: "start", section: "body", key: "size", label, unit: "cm", least: 1, most: 60, logarithmic: true,
  get: (scene, book) => 100 * scene.value(book, "body", "size")?.[axis],
  put: (scene, book, value) => scene.withSize(book, axis, Number((value / 100).toPrecision(12))),
});

/** Ranges are those of the sliders; the field beside one takes whatever the scene may have. */
const kKnobs = [
  {group: "motion", section: "simulation", key: "substeps", label: say("Substeps"), least: 1, most: 1000, logarithmic: true},
  {group: "motion", section: "simulation", key: "time_per_frame", label: say("Time a picture"), least: 1e-4, most: 0.2, logarithmic: true,
    get: (scene) => scene.timePerFrame,
    put: (scene, book, value) => {
      const changed = scene.as(scene.withKeys(book, "simulation", {time_per_frame: value}));
      return changed.withKeys(book, "clip", {speed: undefined});
    }},
  {group: "motion", section: "simulation", key: "stiffness", label: say("Stiffness of a spring"), least: 1, most: 1e5, logarithmic: true},
  {group: "motion", section: "simulation", key: "damping", label: say("Damping, of the critical"), least: 0, most: 2, step: 0.01},
  {group: "start", section: "initial", key: "tilt", label: say("Tilt of the throw"), least: 1e-7, most: 1, logarithmic: true,
    get: (scene, book) => scene.value(book, "initial", "tilt")?.[0] ?? 0,
    put: (scene, book, value) => scene.withTilt(book, value)},
  {group: "start", section: "initial", key: "angular_velocity", label: say("Spin"), least: 0.2, most: 40, logarithmic: true,
    get: (scene, book) => scene.speedAtStart(book),
    put: (scene, book, value) => scene.withSpeed(book, value)},
  sizeKnob(0, say("Width, along x")), sizeKnob(1, say("Height, along y")), sizeKnob(2, say("Thickness, along z")),
  {group: "start", section: "body", key: "mass", label: say("Mass"), least: 0.05, most: 20, logarithmic: true},
  {group: "start", section: "clip", key: "duration", label: say("Length of the motion"), least: 2, most: 600, logarithmic: true},
];

/** The reference frames in which the book is seen. */
const kFrames = {world: say("room"), body: say("book"), turning: say("turning"), momentum: say("momentum")};

const kShownOverlays = {omega: say("ω, angular velocity"), momentum: say("L, angular momentum"), axes: say("axes of the book"), springs: say("springs by strain"),
  polhode: say("ball of spins"), ghost: say("outline of the exact book"), forces: say("forces"), energy_ladder: say("ladder of energies"), poinsot: say("Poinsot’s construction")};
