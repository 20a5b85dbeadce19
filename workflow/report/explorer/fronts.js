// Fronts: exponent and damping are chosen by controls and on the atlas, the panels follow.

const CONTINUUM = ["logarithmic", "unlimited", "heteroclinic"]
const CRITICAL = ["tail", "double_root", "long_wave", "overshoot"]
const SMALLEST_OVERSHOOT = 1e-6, WHITE = [255, 255, 255]

function showFronts({fronts, plane, looks, palettes, alarm}) {
  const exponent = byId("exponent"), damping = byId("damping"), reading = byId("front-reading")
  const {alpha: alphas, gamma: gammas} = fronts
  const value = name => fronts[name][exponent.valueAsNumber][damping.valueAsNumber]
  counted.exponent = alphas
  counted.damping = gammas
  const choosePlace = (alpha, gamma) => {
    exponent.value = nearest(alphas, alpha)
    setControl(damping, nearest(gammas.map(Math.log), Math.log(gamma)))
  }
  const atlas = new Plot("atlas", {x: "exponent α", y: "damping γ", log: true, grab: choosePlace})
  const front = new Plot("front", {x: "ξ = n − ct", y: "relative displacement u"})
  const tail = new Plot("tail", {x: "Re λ", y: "Im λ"})
  const spectrum = new Plot("spectrum", {x: "Re z", y: "Im z"})

  // The plane of overshoots, each place around its exponent and damping.
  const half = (plane.alpha[1] - plane.alpha[0]) / 2, ratio = Math.sqrt(plane.gamma[1] / plane.gamma[0])
  const across = [plane.alpha[0] - half, plane.alpha.at(-1) + half]
  const upwards = [plane.gamma[0] / ratio, plane.gamma.at(-1) * ratio]
  const colours = palettes.overshoot.map(channels), failed = channels(alarm)
  const picture = pictureOf(plane.alpha.length, plane.gamma.length, (row, column) => {
    const overshoot = plane.overshoot[column][row]
    if (overshoot === null) return failed
    if (overshoot < SMALLEST_OVERSHOOT) return WHITE
    return shareOf(colours, 1 - Math.log(overshoot) / Math.log(SMALLEST_OVERSHOOT))
  })
  showColours("atlas", palettes.overshoot, SMALLEST_OVERSHOOT, "1")

  function drawAtlas(alpha, gamma) {
    const grid = alphas.flatMap(one => gammas.map(other => [one, other]))
    const ends = (own, other) => [Math.min(own[0], ...other), Math.max(own[1], ...other)]
    atlas.show(ends(across, alphas), ends(upwards, gammas), plot => {
      plot.picture(picture, across, upwards)
      for (const name of CRITICAL) plot.line(plane.alpha, plane[`critical_damping_${name}`], looks[name])
      plot.dots(grid.map(([one]) => one), grid.map(([, other]) => other), {radius: 1.2, fill: "#fff", edge: "#444", width: 0.5})
      plot.dots([alpha], [gamma], {radius: 8, edge: CURSOR, width: 3})
    })
  }

  function drawFront() {
    const xi = value("xi")
    front.show(widened([xi[0], xi.at(-1)]), [-0.1, 1.9], plot => {
      plot.line(xi, value("relative_displacement"), looks.exact)
      for (const name of CONTINUUM) plot.line(xi, value(`relative_displacement_${name}`), looks[name])
    })
  }

  function drawComplexNumbers() {
    const real = value("tail_root_real"), imaginary = value("tail_root_imaginary")
    const highest = Math.max(...imaginary, 1), angles = range(0, 180).map(k => (k * Math.PI) / 90)
    // Roots and their complex conjugates.
    tail.show(widened([0, Math.max(...real)]), widened([-highest, highest]), plot => {
      for (const sign of [1, -1]) plot.dots(real, imaginary.map(y => sign * y), {edge: INK})
    })
    spectrum.show([-1.15, 1.15], [-1.15, 1.15], plot => {
      plot.line(angles.map(Math.cos), angles.map(Math.sin), {colour: FAINT, width: 1})
      plot.dots(value("multiplier_real"), value("multiplier_imaginary"), {edge: INK})
    })
  }

  function sayReading(alpha, gamma) {
    const [real] = value("tail_root_real"), [imaginary] = value("tail_root_imaginary"), defect = value("translation_defect")
    const tailInWords = imaginary > 0
      ? `oscillates: λ = ${rounded(real)} ± ${rounded(imaginary)} i`
      : `does not oscillate: λ = ${rounded(real)}`
    const translation = defect === null ? "" : `; the one of translation is ${defect.toExponential(0)} from 1`
    const distances = CONTINUUM.map(name => `${looks[name].label} ${rounded(value(`distance_${name}`))}`)
    reading.textContent =
      `α = ${rounded(alpha)}, γ = ${rounded(gamma)}: overshoot ${rounded(value("overshoot"))}, ` +
      `width ${rounded(value("width_10_90"))} beads, error of u ${value("error").toExponential(0)}. ` +
      `The tail that decays slowest ${tailInWords}. ` +
      `Multipliers, ${value("beads_behind")} beads behind: ${value("verdict")}${translation}. ` +
      `Largest distance to the exact front: ${distances.join(", ")}.`
  }

  function choose() {
    const alpha = alphas[exponent.valueAsNumber], gamma = gammas[damping.valueAsNumber]
    drawAtlas(alpha, gamma)
    drawFront()
    drawComplexNumbers()
    sayValue(exponent, `α = ${rounded(alpha)}`)
    sayValue(damping, `γ = ${rounded(gamma)}`)
    sayReading(alpha, gamma)
    keepState()
  }

  for (const slider of [exponent, damping]) slider.addEventListener("input", choose)
  choose()
  return {atlas}
}

// What tests, and whoever opens the console, can ask.
let explorer = null

unpack(byId("content").textContent).then(content => {
  const fronts = showFronts(content), [motions, motion] = showMotions(content)
  followAddress()
  explorer = {fronts, motions, motion}
})
