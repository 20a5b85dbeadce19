// Fronts: exponent and damping are chosen by the controls of the page or on the atlas, the panels follow.

const CONTINUUM = ["logarithmic", "unlimited", "heteroclinic"]

const exponent = byId("exponent"), damping = byId("damping"), reading = byId("front-reading")
const alphas = fronts.alpha, gammas = fronts.gamma

function drawFront() {
  const alpha = alphas[exponent.valueAsNumber], gamma = gammas[damping.valueAsNumber]
  const row = exponent.valueAsNumber * gammas.length + damping.valueAsNumber
  chosen.data = {alpha: [alpha], gamma: [gamma]}
  drawCurves(row)
  drawRoots(row)
  drawMultipliers(row)
  sayValue(exponent, `α = ${rounded(alpha)}`)
  sayValue(damping, `γ = ${rounded(gamma)}`)
  sayReading(alpha, gamma, row)
}

function drawCurves(row) {
  const exact = decodeRow(fronts.relative_displacement, row)
  const first = fronts.first[row], last = fronts.last[row]
  const data = {xi: exact.map((_, k) => first + (k * (last - first)) / (exact.length - 1)), exact}
  for (const name of CONTINUUM)
    data[name] = decodeRow(fronts[`relative_displacement_${name}`], row)
  curves.data = data
  setRange(front_panel.x_range, first, last)
}

// Roots and their complex conjugates.
function drawRoots(row) {
  const real = rowOf("tail_root_real", row), imaginary = rowOf("tail_root_imaginary", row)
  roots.data = {real: [...real, ...real], imaginary: [...imaginary, ...imaginary.map(y => -y)]}
  setRange(tail_panel.x_range, 0, Math.max(...real))
  const highest = Math.max(...imaginary, 1)
  setRange(tail_panel.y_range, -highest, highest)
}

function drawMultipliers(row) {
  const real = decodeRow(fronts.multiplier_real, row)
  const imaginary = decodeRow(fronts.multiplier_imaginary, row)
  multipliers.data = {
    real: real.filter(x => !Number.isNaN(x)),
    imaginary: imaginary.filter(y => !Number.isNaN(y)),
  }
}

function rowOf(name, row) {
  const values = fronts[name], columns = values.shape[1]
  return Array.from({length: columns}, (_, k) => values[row * columns + k])
}

function sayReading(alpha, gamma, row) {
  const value = name => fronts[name][row]
  const real = rowOf("tail_root_real", row)[0], imaginary = rowOf("tail_root_imaginary", row)[0]
  const tail = imaginary > 0
    ? `oscillates: λ = ${rounded(real)} ± ${rounded(imaginary)} i`
    : `does not oscillate: λ = ${rounded(real)}`
  const defect = value("translation_defect")
  const translation = Number.isNaN(defect)
    ? ""
    : `; that of translation is ${defect.toExponential(0)} from 1`
  reading.textContent =
    `α = ${rounded(alpha)}, γ = ${rounded(gamma)}: overshoot ${rounded(value("overshoot"))}, ` +
    `width ${rounded(value("width_10_90"))} beads, error of u ${value("error").toExponential(0)}. ` +
    `The tail that decays slowest ${tail}. ` +
    `Multipliers, ${value("beads_behind")} beads behind: ${value("verdict")}${translation}. ` +
    `Largest distance to the exact front: (45) ${rounded(value("distance_logarithmic"))}, ` +
    `(46) ${rounded(value("distance_unlimited"))}, ` +
    `heteroclinic orbit ${rounded(value("distance_heteroclinic"))}.`
}

exponent.addEventListener("input", drawFront)
damping.addEventListener("input", drawFront)
document.addEventListener("tap-atlas", ({detail: {x, y}}) => {
  exponent.value = nearest(alphas, alpha => Math.abs(alpha - x))
  moveTo(damping, nearest(gammas, gamma => Math.abs(Math.log(gamma / y))))
})

drawFront()
