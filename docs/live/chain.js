/* The motion of a chain: James (2021), equations (31) and (32) with m = 1, in steps of the fourth-order
   Runge–Kutta method. ẋₙ = wₙ + Gₙ₋₁ − Gₙ, ẇₙ = Fₙ₋₁ − Fₙ, uₙ = xₙ − xₙ₊₁, Fₙ = (uₙ)₊^α, Gₙ = γ (uₙ)₊^β. */
class Chain {
  // A scene of gf.simulate_chain: pressure, one striking bead, or a piston.
  constructor({law, beads, boundary, start}) {
    const {left: pressed = 0, velocity: piston = 0} = boundary, velocity = start.velocity ?? piston
    Object.assign(this, {law, count: beads, pressed, piston, time: 0, errors: {compression: 0, velocity: 0}})
    this.delta = pressed || velocity ** (2 / (law.alpha + 1))
    const [fine, coarse, stage, ...slopes] = [1, 2, 3, 4, 5, 6, 7].map(() => new Float64Array(2 * beads))
    Object.assign(this, {states: [fine, coarse], stage, slopes})
    for (const state of this.states) this.setVelocities(state, [velocity])
    this.peaks = new Float64Array(beads - 1)
    this.arrivals = new Float64Array(beads - 1).fill(NaN)
  }

  // Places and velocities stay; w does not, since it depends on the law.
  changeLaw(law) {
    const velocities = this.states.map(state => this.velocities(state))
    this.law = law
    this.states.forEach((state, k) => this.setVelocities(state, velocities[k]))
  }

  setVelocities(state, velocities) {
    state.fill(0, this.count)
    const viscous = this.velocities(state)
    for (let n = 0; n < this.count; n++) state[this.count + n] = (velocities[n] ?? 0) - viscous[n]
  }

  velocities(state) {
    this.slope(state, this.slopes[0])
    return this.slopes[0].slice(0, this.count)
  }

  compressions(state) {
    return state.slice(0, this.count - 1).map((x, n) => x - state[n + 1])
  }

  slope(state, change) {
    const {law: {alpha, beta, gamma}, count} = this
    let elastic = this.pressed ** alpha, viscous = gamma * this.pressed ** beta
    for (let n = 0; n < count; n++) {
      const u = n < count - 1 ? Math.max(state[n] - state[n + 1], 0) : 0
      const F = u && u ** alpha, G = gamma * (alpha === beta ? F : u && u ** beta)
      change[n] = state[count + n] + viscous - G
      change[count + n] = elastic - F
      elastic = F
      viscous = G
    }
    if (this.piston) change[0] = this.piston
  }

  step(state, h) {
    const {slopes, stage} = this
    for (const [k, share] of [0, 0.5, 0.5, 1].entries()) {
      for (let i = 0; i < state.length; i++) stage[i] = state[i] + (k && share * h * slopes[k - 1][i])
      this.slope(stage, slopes[k])
    }
    const [a, b, c, d] = slopes
    for (let i = 0; i < state.length; i++) state[i] += (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i])
  }

  // One long step, and two short ones. The long one resolves waves; what decays faster need only be stable.
  advance() {
    const {law: {alpha, beta, gamma}, delta, states: [fine, coarse], peaks, arrivals} = this
    const frequency = 2 * Math.sqrt(alpha * (2 * delta) ** (alpha - 1))
    const h = 1 / Math.max(8 * frequency, 4 * gamma * beta * (2 * delta) ** (beta - 1))
    const before = this.compressions(fine)
    this.step(coarse, h)
    this.step(fine, h / 2)
    this.step(fine, h / 2)
    for (const [n, u] of this.compressions(fine).entries()) {
      peaks[n] = Math.max(peaks[n], u)
      const share = (delta / 2 - before[n]) / (u - before[n])
      if (isNaN(arrivals[n]) && u >= delta / 2) arrivals[n] = this.time + share * h
    }
    this.time += h
  }

  // What is seen now; its error is the largest difference so far to the run in long steps.
  measure() {
    const seen = state => ({compression: this.compressions(state), velocity: this.velocities(state)})
    const [now, rough] = this.states.map(seen)
    for (const name in now) {
      const differences = now[name].map((value, n) => Math.abs(value - rough[name][n]))
      this.errors[name] = Math.max(this.errors[name], ...differences)
    }
    return now
  }
}

function bisect(isBelow, low, high) {
  const middle = (low + high) / 2
  if (high - low < 1e-14) return middle
  return isBelow(middle) ? bisect(isBelow, middle, high) : bisect(isBelow, low, middle)
}

/* βγ above which the tail e^(λξ) of a front with δ = c = 1 does not swing, for α > 1.19. From there on the
   slowest root λ of α = 1/S(λ) + βγλ, 1/S(λ) = (λ/2)²/sinh²(λ/2), is a real x; below it is a pair x ± iy. */
function criticalDamping(alpha) {
  function inverse(x, y) {
    const a = Math.sinh(x / 2) * Math.cos(y / 2), b = Math.cosh(x / 2) * Math.sin(y / 2), size = 2 * (a * a + b * b)
    const real = (x * a + y * b) / size, imaginary = (y * a - x * b) / size
    return {real: real * real - imaginary * imaginary, imaginary: 2 * real * imaginary}
  }
  function betaGamma(x) {
    const y = bisect(y => inverse(x, y).real > inverse(x, 0).real, 0.01, 2 * Math.PI)
    return -inverse(x, y).imaginary / y
  }
  return betaGamma(bisect(x => inverse(x, 0).real + betaGamma(x) * x > alpha, 0.01, 3))
}

// The page.
const PACE = 8 // beads that a front passes in a second
const CROSSINGS = 1.8 // of the chain by a front, until the motion ends
const OVERLAP = 0.25 // of beads in the picture where u = δ, in diameters

const find = id => document.getElementById(id)
const number = id => Number(find(id).value)
const style = getComputedStyle(document.body), colour = name => style.getPropertyValue(`--${name}`)
const power = value => value && value.toExponential(0).replace(/e-(.*)/, "·10<sup>−$1</sup>")
const law = () => ({alpha: number("alpha"), beta: number("beta"), gamma: number("gamma")})

let chain, front, scene, how = "press", playing = false, shownAt = 0, centre = 1

function begin() {
  const alpha = number("alpha"), delta = number("delta"), free = {kind: "pressure", left: 0, right: 0}
  const speed = delta ** ((alpha - 1) / 2), velocity = delta ** ((alpha + 1) / 2) // (21), (22)
  front = {speed, velocity, critical: criticalDamping(alpha)}
  centre = 1
  const [boundary, start] = {
    press: [{...free, left: delta}, {kind: "rest"}],
    strike: [free, {kind: "striker", beads: 1, velocity}],
    push: [{kind: "piston", velocity}, {kind: "rest"}],
  }[how]
  scene = {law: law(), beads: number("count"), boundary, start, end_time: Math.ceil((CROSSINGS * number("count")) / speed)}
  Object.assign(scene, {tolerance: {relative: 1e-10, absolute: 1e-12}, record: {snapshots: [], grid: {step: 2}}})
  chain = new Chain(scene)
  for (const button of document.querySelectorAll("[aria-pressed]")) button.ariaPressed = button.id === how
  show()
}

function play(on) {
  if (on && chain.time >= scene.end_time) begin()
  if (on && !playing) requestAnimationFrame(now => frame(shownAt = now))
  playing = on
  find("play").textContent = on ? "Pause" : "Play"
}

function frame(now) {
  if (!playing) return
  const wanted = Math.min(chain.time + (PACE / front.speed) * (now - shownAt) / 1000, scene.end_time)
  // A slow machine plays more slowly.
  while (chain.time < wanted && performance.now() < now + 50) chain.advance()
  shownAt = now
  if (chain.time >= scene.end_time) play(false)
  else requestAnimationFrame(frame)
  show()
}

function show() {
  const {compression, velocity} = chain.measure(), half = Math.max(...compression) / 2
  // The front is the last contact with half of the largest compression; where nothing is compressed, it stays.
  if (half > 0.01 * chain.delta) centre += (playing ? 0.15 : 1) * (compression.findLastIndex(u => u > half) + 1 - centre)
  const view = find("follow").checked ? [centre - 22, centre + 10] : [0, chain.count + 1]
  drawBeads(compression, view)
  plot("compression", compression.map(u => u / chain.delta), view, 2, chain.peaks.map(u => u / chain.delta))
  plot("velocity", velocity.map(v => v / front.velocity), view, 3, [])
  read()
}

function clear(id) {
  const canvas = find(id), {clientWidth: width, clientHeight: height} = canvas, pen = canvas.getContext("2d")
  Object.assign(canvas, {width: width * devicePixelRatio, height: height * devicePixelRatio})
  pen.scale(devicePixelRatio, devicePixelRatio)
  return {pen, width, height}
}

function drawBeads(u, [first, last]) {
  const {pen, width, height} = clear("beads"), size = Math.min(width / (last - first), 0.8 * height)
  const move = n => (OVERLAP * chain.states[0][n]) / chain.delta
  const camera = find("follow").checked ? first + move(Math.round(centre) - 1) : first
  pen.strokeStyle = colour("text")
  pen.lineWidth = Math.min(size / 8, 1)
  for (let n = 0; n < chain.count; n++) {
    const x = size * (n + 1 + move(n) - camera), pressed = Math.max((u[n - 1] ?? u[n]) + (u[n] ?? u[n - 1]), 0)
    const share = Math.min((40 * pressed) / chain.delta, 100)
    pen.fillStyle = `color-mix(in srgb, ${colour("compression")} ${share}%, ${colour("back")})`
    pen.beginPath()
    pen.arc(x, height / 2, size / 2, 0, 7)
    pen.fill()
    pen.stroke()
    pen.fillStyle = colour("text")
    if (n === 0 && how !== "strike") pen.fillRect(x - size / 2 - 6, 4, 5, height - 8)
  }
}

function plot(id, values, [first, last], top, peaks) {
  const {pen, width, height} = clear(id), bottom = height - 26
  const x = n => 24 + ((n - first) / (last - first)) * (width - 40)
  const y = value => bottom - ((Math.min(Math.max(value, -0.45), top) + 0.5) / (top + 0.5)) * (bottom - 10)
  pen.font = "14px system-ui, sans-serif"
  pen.textAlign = "center"
  pen.fillStyle = colour("text")
  for (let value = 0; value <= top; value++) {
    pen.fillText(value, 10, y(value) + 5)
    pen.fillRect(24, y(value), width - 40, value === 1 ? 1 : 0.3)
  }
  const apart = last - first > 50 ? 20 : 5
  for (let n = apart; n <= chain.count; n += apart) if (n > first && n < last) pen.fillText(n, x(n), height - 6)
  pen.strokeStyle = colour(id)
  pen.beginPath()
  for (let n = 1; n <= values.length; n++) {
    if (n <= first || n >= last) continue
    pen.fillStyle = colour("peak")
    if (peaks[n - 1]) pen.fillRect(x(n - 0.4), y(peaks[n - 1]) - 1, x(0.8) - x(0), 2)
    pen.fillStyle = colour(id === "compression" && values[n - 1] < -1e-6 ? "open" : id)
    pen.fillRect(x(n) - 3, y(values[n - 1]) - 3, 6, 6)
    pen.lineTo(x(n), y(values[n - 1]))
  }
  pen.stroke()
}

function read() {
  const {alpha, beta, gamma} = law(), {count, delta, errors} = chain
  const near = Math.floor(count / 3), far = Math.floor((2 * count) / 3)
  const speed = (far - near) / (chain.arrivals[far - 1] - chain.arrivals[near - 1])
  const damping = gamma * delta ** (beta - (alpha + 1) / 2), critical = front.critical / beta
  const words = {
    near, far, contact: far, time: chain.time.toFixed(1),
    speed: speed ? speed.toFixed(4) : "—", formula: front.speed.toFixed(4),
    peak: chain.peaks[far - 1] ? (chain.peaks[far - 1] / delta).toFixed(4) : "—",
    damping: damping.toFixed(4), critical: critical.toFixed(4), ratio: (damping / critical).toFixed(2),
    compressionError: power(errors.compression / delta), velocityError: power(errors.velocity / front.velocity),
    python: JSON.stringify({...scene, law: law()}).replaceAll(",", ", "),
  }
  for (const id in words) if (find(id).innerHTML !== words[id]) find(id).innerHTML = words[id]
  for (const slider of document.querySelectorAll("[type=range]")) slider.nextElementSibling.value = slider.value
}

for (const button of document.querySelectorAll("[aria-pressed]")) button.onclick = () => {
  how = button.id
  begin()
  play(true)
}
for (const slider of document.querySelectorAll("[type=range]")) slider.oninput = () => {
  if (slider.id === "alpha" && number("beta") === chain.law.alpha) find("beta").value = slider.value
  if (chain.time >= scene.end_time) play(true)
  else if (["beta", "gamma"].includes(slider.id)) chain.changeLaw(law())
  else begin()
  show()
}
find("play").onclick = () => play(!playing)
find("follow").onchange = window.onresize = matchMedia("(prefers-color-scheme: dark)").onchange = show
begin()
play(!matchMedia("(prefers-reduced-motion: reduce)").matches)
