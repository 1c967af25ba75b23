// What tables, plots and legends are made of.

function element(name, attributes = {}, ...children) {
  const svg = ["svg", "path", "circle", "line", "text"].includes(name);
  const result = svg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    result.setAttribute(key, value);
  result.append(...children);
  return result;
}

function countText(n) { return n.toLocaleString("en-US"); }

function counted(n, one) { return `${countText(n)} ${one}${n === 1 ? "" : "s"}`; }

function shortNumber(x) {
  if (x === null || x === undefined)
    return "not finite";
  if (Number.isInteger(x) && Math.abs(x) < 1e6)
    return countText(x);
  return Math.abs(x) >= 1e-3 && Math.abs(x) < 1e5 ? String(+x.toPrecision(6)) : x.toExponential(2);
}

function seconds(s) { return s < 0.0995 ? (1000 * s).toFixed(s < 0.00995 ? 1 : 0) + " ms" : s.toFixed(2) + " s"; }

function table(rows) {
  const row = ([name, value]) => element("tr", {}, element("th", { scope: "row" }, name),
    element("td", {}, typeof value === "number" ? shortNumber(value) : value));
  return element("table", {}, element("tbody", {}, ...rows.map(row)));
}

function section(title, ...children) { return element("section", {}, element("h2", {}, title), ...children); }

function note(text) { return element("p", { class: "note" }, text); }
