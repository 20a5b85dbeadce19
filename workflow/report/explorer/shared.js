// What both halves of the page need; it stands before each of their scripts.

const MISSING = -32768
const MARGIN = 0.05

const byId = name => document.getElementById(name)

// A row of an array as workflow/scripts/report/explorer/encoding.py encodes it.
function decodeRow(encoded, row) {
  const codes = encoded.codes, step = encoded.steps[row]
  const columns = codes.shape[1], values = new Float64Array(columns)
  for (let k = 0; k < columns; k++) {
    const code = codes[row * columns + k]
    values[k] = code === MISSING ? NaN : code * step
  }
  return values
}

// How far the values of a row may be from those that were encoded.
const roundingError = (encoded, row) => 0.5 * encoded.steps[row]

// A number with the decimals that its error leaves; the error is rounded up and covers this rounding too.
function withError(value, error) {
  if (!(error > 0)) return `${value}`
  const decimals = Math.min(Math.max(1 - Math.floor(Math.log10(error)), 0), 16)
  const shown = (Math.ceil(error * 10 ** decimals) + 1) / 10 ** decimals
  return `${value.toFixed(decimals)} ± ${Number(shown.toPrecision(2))}`
}

const rounded = value => `${Number(value.toPrecision(4))}`

function setRange(range, start, end) {
  const margin = MARGIN * (end - start)
  const limits = {start: start - margin, end: end + margin}
  range.setv({...limits, reset_start: limits.start, reset_end: limits.end})
}

// What a slider stands for, in words, for eyes and for screen readers.
function sayValue(slider, words) {
  byId(`${slider.id}-value`).textContent = words
  slider.setAttribute("aria-valuetext", words)
}

// Moves a slider as a hand would.
function moveTo(slider, value) {
  slider.value = value
  slider.dispatchEvent(new Event("input"))
}

// The number of the entry that a measure finds least.
function nearest(values, measure) {
  let best = 0
  for (let k = 1; k < values.length; k++) if (measure(values[k]) < measure(values[best])) best = k
  return best
}
