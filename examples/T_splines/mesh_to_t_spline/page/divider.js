// The divider between the input mesh, on its left, and the T-spline surface, on its right.

// Keeps the place within the picture, with all of the handle to be seen.
function dividerPlace(x) { return Math.min(0.98, Math.max(0.02, x)); }

function showDivider(options) {
  const divider = document.getElementById("divider"), percent = 100 * options.compare;
  divider.hidden = !(options.compared && options.view.ofSpline);
  divider.style.left = `${percent}%`;
  divider.setAttribute("aria-valuenow", percent.toFixed(0));
}

// move: called when the place has changed.
function listenToDivider(options, move) {
  const divider = document.getElementById("divider");
  const moveTo = place => {
    options.compare = dividerPlace(place);
    showDivider(options);
    move();
  };
  divider.addEventListener("pointerdown", event => {
    divider.setPointerCapture(event.pointerId);
    event.preventDefault();
    divider.focus();
  });
  divider.addEventListener("pointermove", event => {
    if (!divider.hasPointerCapture(event.pointerId))
      return;
    const box = divider.parentElement.getBoundingClientRect();
    moveTo((event.clientX - box.left) / box.width);
  });
  divider.addEventListener("keydown", event => {
    const steps = { ArrowLeft: -0.02, ArrowDown: -0.02, ArrowRight: 0.02, ArrowUp: 0.02, Home: -1, End: 1 };
    if (!(event.key in steps))
      return;
    moveTo(options.compare + steps[event.key]);
    event.preventDefault();
  });
}
