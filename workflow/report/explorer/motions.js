// Motions: scene, time and bead are chosen by the controls of the page, the panels follow.

const REACH = 12 // rest places on either side of the cursor that the panel of beads shows
const NEIGHBOURS = 24 // beads on either side that are placed; compression brings them into view
const OVERLAP = 0.4 // share of a diameter by which the largest compression brings two beads closer
const FRAME = 60 // milliseconds between two moments of the film
const GAPS_SHOWN = 0.6 // of the largest compression, downwards; deeper gaps are marked at the edge

const scene = byId("scene"), field = byId("field"), time = byId("time"), bead = byId("bead")
const play = byId("play"), reading = byId("motion-reading")

const motion = () => motions[scene.value]

const numbersOf = values => Array.from(values, (_, k) => k + 1)

// Numbers of the contacts that are open: extended by more than the error of u, where no force holds them.
function openContacts(u, row) {
  const chosen = motion(), encoded = chosen.relative_displacement
  const error = encoded.error + roundingError(encoded, row)
  return numbersOf(u).filter(n => chosen.opens && u[n - 1] < -error)
}

function chooseScene() {
  const chosen = motion(), times = chosen.times, count = chosen.beads
  const largest = chosen.largest
  time.max = times.length - 1
  time.value = Math.floor(0.17 * times.length)
  bead.max = count
  // The bead that is compressed most, at the front.
  const u = decodeRow(chosen.relative_displacement, time.valueAsNumber)
  bead.value = u.indexOf(Math.max(...u)) + 1
  setRange(panels.relative_displacement.x_range, 1, count)
  setRange(panels.relative_displacement.y_range, -GAPS_SHOWN * largest, largest)
  setRange(panels.velocity.y_range, chosen.slowest, chosen.fastest)
  setRange(panels.spacetime.x_range, 1, count)
  setRange(panels.spacetime.y_range, times[0], times[times.length - 1])
  bead_colours.setv({low: Math.min(0, chosen.slowest), high: chosen.fastest})
  drawSpacetime()
  drawMoment()
}

function drawSpacetime() {
  const chosen = motion(), times = chosen.times, count = chosen.beads
  const values = new Float32Array(times.length * count)
  for (let row = 0; row < times.length; row++)
    values.set(decodeRow(chosen[field.value], row), row * count)
  const Picture = picture.data.image[0].constructor
  const step = times.length > 1 ? times[1] - times[0] : 1
  picture.data = {
    image: [new Picture(values, [times.length, count])],
    x: [0.5], y: [times[0] - 0.5 * step], dw: [count], dh: [step * times.length],
  }
  const compressed = field.value === "relative_displacement", look = looks[field.value]
  colours.setv({
    palette: look.palette,
    low_color: chosen.opens ? look.low_color : null,
    low: compressed ? -chosen.largest : Math.min(0, chosen.slowest),
    high: compressed ? chosen.largest : chosen.fastest,
  })
}

function drawMoment() {
  const chosen = motion(), row = time.valueAsNumber, n = bead.valueAsNumber
  const t = chosen.times[row]
  const u = decodeRow(chosen.relative_displacement, row)
  const v = decodeRow(chosen.velocity, row)
  const open = openContacts(u, row)
  profile.data = {n: numbersOf(u), u, v}
  const lowest = -GAPS_SHOWN * chosen.largest
  gaps.data = {n: open, u: open.map(number => Math.max(u[number - 1], lowest))}
  time_cursor.location = t
  for (const cursor of bead_cursors) cursor.location = n
  drawBeads(n, u, v, open)
  sayValue(time, `t = ${rounded(t)}`)
  sayValue(bead, `n = ${n}`)
  sayReading(t, n, open.length, row, {relative_displacement: u, velocity: v})
}

// Bead n stays where it is, and the others are placed by the contacts between.
function drawBeads(n, u, v, open) {
  const scale = OVERLAP / motion().largest
  const first = Math.max(1, n - NEIGHBOURS), last = Math.min(u.length, n + NEIGHBOURS)
  const place = new Map([[n, n]])
  for (let k = n; k < last; k++) place.set(k + 1, place.get(k) + 1 - scale * u[k - 1])
  for (let k = n; k > first; k--) place.set(k - 1, place.get(k) - 1 + scale * u[k - 2])
  const shown = []
  for (let k = first; k <= last; k++) shown.push(k)
  beads.data = {
    x: shown.map(k => place.get(k)),
    n: shown,
    v: shown.map(k => v[k - 1]),
    edge: shown.map(k => (k === n ? "#b35900" : "#1d2733")),
  }
  const wide = open.filter(k => k >= first && k < last)
  openings.data = {
    start: wide.map(k => place.get(k) + 0.5),
    stop: wide.map(k => place.get(k + 1) - 0.5),
  }
  panels.beads.x_range.setv({start: n - REACH - 0.5, end: n + REACH + 0.5})
}

function sayReading(t, n, open, row, values) {
  const say = name => {
    const encoded = motion()[name]
    return withError(values[name][n - 1], encoded.error + roundingError(encoded, row))
  }
  const contacts = open === 0 ? "No contact is open" : `Open contacts: ${open}`
  reading.textContent =
    `At t = ${rounded(t)}, bead ${n}: relative displacement ${say("relative_displacement")}, ` +
    `velocity ${say("velocity")}. ${contacts}.`
}

let film = null

function stop() {
  clearInterval(film)
  film = null
  play.textContent = "Play"
  reading.ariaLive = "polite"
}

function start() {
  if (time.valueAsNumber >= Number(time.max)) time.value = 0
  play.textContent = "Pause"
  // A screen reader would speak of every moment of the film.
  reading.ariaLive = "off"
  film = setInterval(() => {
    time.stepUp()
    drawMoment()
    if (time.valueAsNumber >= Number(time.max)) stop()
  }, FRAME)
}

scene.addEventListener("input", () => { stop(); chooseScene() })
field.addEventListener("input", drawSpacetime)
time.addEventListener("input", drawMoment)
bead.addEventListener("input", drawMoment)
play.addEventListener("click", () => (film === null ? start() : stop()))
document.addEventListener("tap-spacetime", ({detail: {x, y}}) => {
  bead.value = Math.round(x)
  moveTo(time, nearest(motion().times, t => Math.abs(t - y)))
})

chooseScene()
