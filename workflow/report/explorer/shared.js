// What motions and fronts share: stored arrays, plots on a canvas, and the state of the page in its address.

const MARGIN = 0.04, INK = "#1d2733", FAINT = "#5a6673", GRID = "#e4e8ec", CURSOR = "#b35900"

const byId = name => document.getElementById(name)
const range = (first, last) => Array.from({length: Math.max(last - first + 1, 0)}, (_, k) => first + k)
const rounded = value => `${Number((value ?? NaN).toPrecision(4))}`

// The data of the page: JSON, compressed, in base 64.
function unpack(text) {
  const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0))
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).json()
}

// A number that was rounded to some digits, with the decimals that its error leaves; the error is rounded up.
function withError(value, solved, digits) {
  const error = solved + (value && 0.5 * 10 ** (Math.floor(Math.log10(Math.abs(value))) + 1 - digits))
  if (!(error > 0)) return `${value}`
  const decimals = Math.min(Math.max(1 - Math.floor(Math.log10(error)), 0), 16)
  const shown = (Math.ceil(error * 10 ** decimals) + 1) / 10 ** decimals
  return `${value.toFixed(decimals)} ± ${Number(shown.toPrecision(2))}`
}

// The index of the value that is nearest to a number.
const nearest = (values, number) =>
  values.reduce((best, value, k) => (Math.abs(value - number) < Math.abs(values[best] - number) ? k : best), 0)

const extreme = (choice, rows) => choice(...rows.map(row => choice(...row)))
const widened = ([low, high]) => [low - MARGIN * (high - low), high + MARGIN * (high - low)]

function ticksOf([low, high], log, count) {
  const power = 10 ** Math.floor(Math.log10((high - low) / count))
  const step = power * [1, 2, 5, 10].find(factor => (factor * power * count) / (high - low) > 0.999)
  const ticks = log
    ? range(Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))).flatMap(p => [1, 2, 5].map(m => m * 10 ** p))
    : range(Math.ceil(low / step), Math.floor(high / step)).map(k => k * step)
  return ticks.map(tick => Number(tick.toPrecision(10))).filter(tick => tick >= low && tick <= high)
}

// A picture of some columns and rows, the first row at the bottom, from the colour [red, green, blue] of each place.
function pictureOf(columns, rows, colourAt) {
  const canvas = Object.assign(document.createElement("canvas"), {width: columns, height: rows})
  const image = new ImageData(columns, rows)
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++)
      image.data.set([...colourAt(row, column), 255], 4 * ((rows - 1 - row) * columns + column))
  canvas.getContext("2d").putImageData(image, 0, 0)
  return canvas
}

const channels = colour => [1, 3, 5].map(start => parseInt(colour.slice(start, start + 2), 16))
const shareOf = (palette, share) => palette[Math.round(Math.min(Math.max(share, 0), 1) * (palette.length - 1))]

function showColours(name, palette, low, high) {
  byId(`${name}-colours`).style.background = `linear-gradient(to right, ${palette.join()})`
  byId(`${name}-low`).textContent = low
  byId(`${name}-high`).textContent = high
}

// Axes on a canvas. A hand on it calls `grab` with the place that it points at.
class Plot {
  constructor(name, {x, y = "", log = false, grab = null}) {
    Object.assign(this, {canvas: byId(name), labels: [x, y], log, xRange: [0, 1], yRange: [0, 1], paint() {}})
    this.left = y ? 62 : 12
    new ResizeObserver(() => this.draw()).observe(this.canvas)
    if (!grab) return
    this.canvas.classList.add("grabbed")
    const point = event => {
      if (event.buttons !== 1) return
      this.canvas.setPointerCapture(event.pointerId)
      const box = this.canvas.getBoundingClientRect(), [x0, x1] = this.xRange, [y0, y1] = this.yRange
      const right = (event.clientX - box.left - this.left) / this.width
      const up = (this.bottom - event.clientY + box.top) / this.height
      grab(x0 + right * (x1 - x0), this.log ? y0 * (y1 / y0) ** up : y0 + up * (y1 - y0))
    }
    for (const kind of ["pointerdown", "pointermove"]) this.canvas.addEventListener(kind, point)
  }

  show(xRange, yRange, paint) {
    Object.assign(this, {xRange, yRange, paint})
    this.draw()
  }

  draw() {
    const {clientWidth, clientHeight} = this.canvas, scale = devicePixelRatio, pen = this.canvas.getContext("2d")
    Object.assign(this.canvas, {width: clientWidth * scale, height: clientHeight * scale})
    Object.assign(this, {pen, width: clientWidth - this.left - 12, height: clientHeight - 54, bottom: clientHeight - 44})
    pen.scale(scale, scale)
    pen.font = "12px system-ui, sans-serif"
    this.drawAxes()
    pen.save()
    pen.beginPath()
    pen.rect(this.left, this.bottom - this.height, this.width, this.height)
    pen.clip()
    this.paint(this)
    pen.restore()
  }

  x(value) { return this.left + (this.width * (value - this.xRange[0])) / (this.xRange[1] - this.xRange[0]) }

  y(value) {
    const [low, high, place] = [...this.yRange, value].map(this.log ? Math.log : Number)
    return this.bottom - (this.height * (place - low)) / (high - low)
  }

  drawAxes() {
    const {pen, left, bottom, width, height, labels: [xLabel, yLabel]} = this
    pen.fillStyle = FAINT
    pen.textAlign = "center"
    for (const tick of ticksOf(this.xRange, false, Math.min(width / 70, 10))) {
      this.line([tick, tick], this.yRange, {colour: GRID, width: 1})
      pen.fillText(tick, this.x(tick), bottom + 16)
    }
    pen.fillText(xLabel, left + width / 2, bottom + 36)
    if (!yLabel) return
    pen.textAlign = "right"
    for (const tick of ticksOf(this.yRange, this.log, height / 45)) {
      this.line(this.xRange, [tick, tick], {colour: GRID, width: 1})
      pen.fillText(tick, left - 6, this.y(tick) + 4)
    }
    pen.textAlign = "center"
    pen.save()
    pen.translate(14, bottom - height / 2)
    pen.rotate(-Math.PI / 2)
    pen.fillText(yLabel, 0, 0)
    pen.restore()
  }

  line(xs, ys, {colour, dash = [], width = 2}) {
    Object.assign(this.pen, {strokeStyle: colour, lineWidth: width, lineJoin: "round"})
    this.pen.setLineDash(dash)
    this.pen.beginPath()
    for (let k = 0; k < xs.length; k++)
      if (Number.isFinite(ys[k])) this.pen.lineTo(this.x(xs[k]), this.y(ys[k]))
    this.pen.stroke()
    this.pen.setLineDash([])
  }

  dots(xs, ys, {radius = 3, fill = "#0000", edge = "#0000", width = 1}) {
    for (let k = 0; k < xs.length; k++) {
      const colours = [fill, edge].map(colour => (Array.isArray(colour) ? colour[k] : colour))
      Object.assign(this.pen, {fillStyle: colours[0], strokeStyle: colours[1], lineWidth: width})
      this.pen.beginPath()
      this.pen.arc(this.x(xs[k]), this.y(ys[k]), radius, 0, 2 * Math.PI)
      this.pen.fill()
      this.pen.stroke()
    }
  }

  picture(canvas, [x0, x1], [y0, y1]) {
    this.pen.imageSmoothingEnabled = false
    this.pen.drawImage(canvas, this.x(x0), this.y(y1), this.x(x1) - this.x(x0), this.y(y0) - this.y(y1))
  }
}

// What a slider means, in words, for eyes and for screen readers.
function sayValue(slider, words) {
  byId(`${slider.id}-value`).textContent = words
  slider.setAttribute("aria-valuetext", words)
}

// Sets a control, and lets the page know.
function setControl(control, value) {
  control.value = value
  control.dispatchEvent(new Event("input"))
}

// Numbers that sliders count through, by the name of the slider: the address holds these numbers.
const counted = {}
const controls = () => [...document.querySelectorAll("input, select")].filter(one => !one.closest("[hidden]"))
const stateNow = () => controls().map(({id, value}) => `${id}=${counted[id]?.[value] ?? value}`).join("&")

// A scene sets the limits of its times and beads, so that the order of the page is kept.
function restore(state) {
  const asked = new URLSearchParams(state)
  for (const control of document.querySelectorAll("input, select")) {
    const value = asked.get(control.id), numbers = counted[control.id]
    const known = value !== null && (!control.options || [...control.options].some(option => option.value === value))
    if (known) setControl(control, numbers ? nearest(numbers, Number(value)) : value)
  }
}

let writing = null

// Browsers count how often an address changes: it is written when the hand rests.
function keepState() {
  clearTimeout(writing)
  writing = setTimeout(() => history.replaceState(null, "", `#${stateNow()}`), 200)
}

function followAddress() {
  restore(location.hash.slice(1))
  addEventListener("hashchange", () => restore(location.hash.slice(1)))
  for (const button of document.querySelectorAll("button[data-state]"))
    button.addEventListener("click", () => {
      location.hash = button.dataset.state
      byId(button.dataset.section).scrollIntoView()
    })
}
