// A chain computed in a browser: quick, and far less accurate than the package.

const ROWS = 240 // moments that are kept
const CROSSINGS = 1.6 // of the chain by a front, until the motion ends

const range = (first, last) => Array.from({length: Math.max(last - first + 1, 0)}, (_, k) => first + k)
const extreme = (choice, rows) => choice(...rows.map(row => choice(...row)))

/* Runge–Kutta steps of fourth order of James (2021), equations (31) and (32), m = 1, between free ends or with u₀ = δ held:
   xₙ' = wₙ + G(uₙ₋₁) − G(uₙ), wₙ' = F(uₙ₋₁) − F(uₙ), uₙ = xₙ − xₙ₊₁, F = u₊^α, G = γ u₊^β. */
function integrate({alpha, beta, gamma, drive, count, start}, {interval, steps}) {
  const pressed = start === "press", size = 2 * count, h = interval / steps
  const outer = pressed ? drive : 0
  function slope(state, change) {
    let elastic = outer ** alpha, viscous = gamma * outer ** beta
    for (let n = 0; n < count; n++) {
      const u = n < count - 1 ? Math.max(state[n] - state[n + 1], 0) : 0
      const F = u && u ** alpha, G = gamma * (alpha === beta ? F : u ** beta)
      change[n] = state[count + n] + viscous - G
      change[count + n] = elastic - F
      elastic = F
      viscous = G
    }
  }
  const [state, stage, ...slopes] = range(1, 6).map(() => new Float64Array(size))
  // Bead 1 is at rest under pressure.
  state[count] = pressed ? -gamma * drive ** beta : drive
  const u = [], v = []
  const keep = () => {
    slope(state, slopes[0])
    u.push(state.slice(0, count - 1).map((x, n) => x - state[n + 1]))
    v.push(slopes[0].slice(0, count))
  }
  keep()
  for (let row = 1; row <= ROWS; row++) {
    for (let step = 0; step < steps; step++) {
      for (const [k, share] of [0, 0.5, 0.5, 1].entries()) {
        for (let i = 0; i < size; i++) stage[i] = state[i] + (k ? share * h * slopes[k - 1][i] : 0)
        slope(stage, slopes[k])
      }
      const [a, b, c, d] = slopes
      for (let i = 0; i < size; i++) state[i] += (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i])
    }
    keep()
  }
  return {u, v}
}

// A motion at equal times, with its distance to a run of steps twice as long as its error.
function computeChain(chain) {
  const {alpha, beta, gamma, drive, count, start} = chain
  // At most twice what is held, or what stops the energy of the first collision.
  const deepest = start === "press" ? 2 * drive : (((alpha + 1) * drive ** 2) / 4) ** (1 / (alpha + 1))
  const speed = Math.sqrt((start === "press" ? drive : deepest) ** (alpha - 1))
  const frequency = 2 * Math.sqrt(alpha * deepest ** (alpha - 1)), decay = 4 * gamma * beta * deepest ** (beta - 1)
  // Waves are resolved; what decays faster need only be stable, also with steps twice as long.
  const interval = (CROSSINGS * count) / (speed * ROWS), steps = 2 * Math.ceil(interval * Math.max(10 * frequency, decay))
  const {u, v} = integrate(chain, {interval, steps}), rough = integrate(chain, {interval, steps: steps / 2})
  const field = (rows, others) => ({
    rows,
    error: extreme(Math.max, rows.map((row, k) => row.map((value, n) => Math.abs(value - others[k][n])))),
  })
  return {
    times: u.map((_, k) => k * interval),
    relative_displacement: field(u, rough.u), velocity: field(v, rough.v),
  }
}
