// Colours that the picture and its legends share.

const coneColors = { 1: "#7b1fa2", 2: "#d81b60", 3: "#e53935", 5: "#1e66d0", 6: "#00a2a8", 7: "#2e9e44", 8: "#8bb021" };

// Not those of cones: both are in one picture.
const cornerColors = { 1: "#3949ab", 3: "#00c2a0", 4: "#ff9800" };

const jointColor = [1, 1, 1];

function coneColor(k) { return coneColors[k] || (k < 1 ? "#000000" : "#f2b705"); }

// Of a corner of the border, where 2 quarter turns are regular.
function cornerColor(k) { return cornerColors[k] || "#5d4037"; }

function colorComponents(hex) { return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16) / 255); }

// Of the curvature, from the lowest to the highest, in equal steps.
const curvatureColors = ["#1b4f9c", "#6fa8d6", "#f7f7f5", "#ec9173", "#a8172b"];

// Of the deviation, from 0 to the largest, in equal steps: magma, from its light end on, without the last tenth.
const deviationColors = ["#fcfdbf", "#fecf92", "#fe9f6d", "#f7705c", "#de4968", "#b73779", "#8c2981", "#641a80", "#3b0f70", "#140e36"];

const undefinedColor = "#8f9499";

const extraordinaryColor = "#f2b705", netColor = "#008577", edgeColor = "#172138", borderColor = "#0b6bcb", creaseColor = "#c2188f";

function glslColor(hex) { return `vec3(${colorComponents(hex).map(x => x.toFixed(4)).join(", ")})`; }
