// Both halves of the page, as `explorer` for tests and for the console.

let explorer = null

unpack(byId("content").textContent).then(content => {
  const shown = {motions: showMotions(content), fronts: showFronts(content)}
  followAddress()
  explorer = shown
})
