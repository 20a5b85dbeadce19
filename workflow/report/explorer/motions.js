// Motions: scene, time and bead are chosen by controls and on pictures, the panels follow.

const REACH = 12 // rest places on either side of the bead that the panel of beads shows
const NEIGHBOURS = 24 // beads on either side that are placed; compression brings them into view
const OVERLAP = 0.4 // share of a diameter by which the largest compression brings two beads closer
const FRAME = 60 // milliseconds between two moments of the film
const GAPS_SHOWN = 0.6 // of the largest compression, downwards; deeper gaps are marked at the edge
const LIVE = ["alpha", "beta", "gamma", "drive", "count"]

// The first bead that the front has reached: ahead of it the compression falls most.
function frontOf(u) {
  const fall = k => Math.max(u[k], 0) - Math.max(u[k + 1], 0)
  return range(0, u.length - 2).reduce((best, k) => (fall(k) > fall(best) ? k : best), 0) + 1
}

// A motion with its number of beads and how far colours and axes go; gaps may be wider than the largest compression.
function withExtent(motion) {
  const [largest, fastest] = ["relative_displacement", "velocity"].map(name => extreme(Math.max, motion[name].rows))
  return {...motion, beads: motion.velocity.rows[0].length, largest, fastest, slowest: extreme(Math.min, motion.velocity.rows)}
}

function showMotions({motions, palettes, alarm, digits}) {
  const scene = byId("scene"), field = byId("field"), time = byId("time"), bead = byId("bead")
  const play = byId("play"), reading = byId("motion-reading")
  const grabBead = x => { stop(); setControl(bead, Math.round(x)) }
  const grabMoment = (x, t) => { grabBead(x); setControl(time, nearest(motion.times, t)) }
  const plots = {
    beads: new Plot("beads", {x: "place, in bead diameters"}),
    u: new Plot("compression", {x: "contact n", y: "relative displacement uₙ", grab: grabBead}),
    v: new Plot("velocity", {x: "bead n", y: "velocity ẋₙ", grab: grabBead}),
    spacetime: new Plot("spacetime", {x: "bead n", y: "time t", grab: grabMoment}),
  }
  let motion, picture, film = null

  const rowOf = name => motion[name].rows[time.valueAsNumber]

  function chooseScene() {
    stop()
    const live = scene.value === "live"
    for (const part of document.querySelectorAll(".live")) part.hidden = !live
    motion = withExtent(live ? chainOfControls() : {...motions[scene.value], digits})
    counted.time = motion.times
    time.max = motion.times.length - 1
    time.value = Math.floor(0.17 * motion.times.length)
    bead.max = motion.beads
    bead.value = frontOf(rowOf("relative_displacement"))
    drawSpacetime()
  }

  function chainOfControls() {
    const chain = Object.fromEntries(LIVE.map(id => [id, byId(id).valueAsNumber]))
    for (const id of LIVE) sayValue(byId(id), `${byId(`${id}-value`).dataset.symbol} = ${chain[id]}`)
    return computeChain({...chain, start: byId("start").value})
  }

  function drawSpacetime() {
    const {largest, slowest, fastest, opens, times} = motion, {rows} = motion[field.value]
    const compressed = field.value === "relative_displacement"
    const [low, high] = compressed ? [-largest, largest] : [Math.min(0, slowest), fastest]
    const palette = palettes[field.value], colours = palette.map(channels), red = channels(alarm)
    picture = pictureOf(rows[0].length, times.length, (row, column) => {
      const value = rows[row][column]
      return compressed && opens && value < low ? red : shareOf(colours, (value - low) / (high - low))
    })
    showColours("spacetime", palette, rounded(low), rounded(high))
    drawMoment()
  }

  function drawMoment() {
    const {largest, slowest, fastest, times, beads} = motion, n = bead.valueAsNumber, t = times[time.valueAsNumber]
    const u = rowOf("relative_displacement"), v = rowOf("velocity")
    const open = range(1, u.length).filter(k => motion.opens && u[k - 1] < -motion.relative_displacement.error)
    const along = widened([1, beads]), gaps = [-GAPS_SHOWN * largest, largest], speeds = [slowest, fastest]
    const cursor = plot => plot.line([n, n], plot.yRange, {colour: CURSOR, width: 1.5})
    const curve = (plot, values) => {
      const numbers = range(1, values.length)
      cursor(plot)
      plot.line(numbers, values, {colour: INK, width: 1})
      plot.dots(numbers, values, {radius: 1.5, fill: INK})
    }
    plots.u.show(along, widened(gaps), plot => {
      curve(plot, u)
      plot.dots(open, open.map(k => Math.max(u[k - 1], gaps[0])), {radius: 4, edge: alarm, width: 2})
    })
    plots.v.show(along, widened(speeds), plot => curve(plot, v))
    const step = times[1] - times[0], rows = [times[0] - step / 2, times.at(-1) + step / 2]
    plots.spacetime.show(along, widened([times[0], times.at(-1)]), plot => {
      plot.picture(picture, [0.5, picture.width + 0.5], rows)
      cursor(plot)
      plot.line(plot.xRange, [t, t], {colour: CURSOR, width: 1.5})
    })
    drawBeads(n, u, v, open)
    sayValue(time, `t = ${rounded(t)}`)
    sayValue(bead, `n = ${n}`)
    sayReading(t, n, u, open)
    keepState()
  }

  // Bead n stays where it is, and the others are placed by the contacts between.
  function drawBeads(n, u, v, open) {
    const [first, last] = [Math.max(1, n - NEIGHBOURS), Math.min(v.length, n + NEIGHBOURS)]
    const place = {[n]: n}, apart = k => 1 - (OVERLAP / motion.largest) * u[k - 1]
    for (let k = n; k < last; k++) place[k + 1] = place[k] + apart(k)
    for (let k = n - 1; k >= first; k--) place[k] = place[k + 1] - apart(k)
    const shown = range(first, last), low = Math.min(0, motion.slowest)
    const fill = shown.map(k => shareOf(palettes.velocity, (v[k - 1] - low) / (motion.fastest - low)) + "bf")
    plots.beads.show([n - REACH - 0.5, n + REACH + 0.5], [-1, 1], plot => {
      const radius = (plot.x(1) - plot.x(0)) / 2
      const edge = shown.map(k => (k === n ? CURSOR : INK))
      plot.dots(shown.map(k => place[k]), shown.map(() => 0), {radius, fill, edge, width: 1.5})
      for (const k of open.filter(k => k >= first && k < last))
        plot.line([place[k] + 0.5, place[k + 1] - 0.5], [0, 0], {colour: alarm, dash: [3, 3], width: 3})
    })
    Object.assign(plots.beads, {shown, place})
  }

  function sayReading(t, n, u, open) {
    const say = name => withError(rowOf(name)[n - 1], motion[name].error, motion.digits)
    const contact = n <= u.length ? `relative displacement ${say("relative_displacement")}, ` : "the last one, "
    const contacts = open.length === 0 ? "No contact is open" : `Open contacts: ${open.length}`
    reading.textContent = `At t = ${rounded(t)}, bead ${n}: ${contact}velocity ${say("velocity")}. ${contacts}.`
  }

  function stop() {
    clearInterval(film)
    film = null
    play.textContent = "Play"
    reading.ariaLive = "polite"
  }

  function start() {
    if (time.value === time.max) time.value = 0
    play.textContent = "Pause"
    // A screen reader would speak of every moment of the film.
    reading.ariaLive = "off"
    film = setInterval(() => {
      time.stepUp()
      bead.value = frontOf(rowOf("relative_displacement"))
      drawMoment()
      if (time.value === time.max) stop()
    }, FRAME)
  }

  for (const control of [scene, byId("start"), ...LIVE.map(byId)]) control.addEventListener("input", chooseScene)
  field.addEventListener("input", drawSpacetime)
  for (const slider of [time, bead]) slider.addEventListener("input", drawMoment)
  play.addEventListener("click", () => (film === null ? start() : stop()))
  chooseScene()
  return [plots, () => motion]
}
