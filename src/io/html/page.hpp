#pragma once

#include <string_view>

/// The fixed parts of the replay's page: what comes before and after the picture and the data.
namespace osculo::io::html {

inline constexpr std::string_view kHead = R"html(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<style>
body { margin: 0; padding: 16px; background: #fff; color: #222; font: 14px Helvetica, Arial, sans-serif; }
main { display: flex; flex-wrap: wrap; gap: 16px; align-items: flex-start; }
figure { margin: 0; flex: 1 1 480px; }
figure svg { width: 100%; height: auto; max-height: 82vh; }
aside { flex: 0 1 300px; }
nav { display: flex; gap: 8px; align-items: center; margin: 8px 0; }
nav input[type=range] { flex: 1; }
button, select { font: inherit; padding: 2px 10px; }
ol { margin: 8px 0; padding: 0 0 0 4px; max-height: 68vh; overflow-y: auto; list-style: none; }
li { cursor: pointer; padding: 1px 4px; white-space: nowrap; font-variant-numeric: tabular-nums; }
li.past { color: #222; } li { color: #9aa3ad; } li.now { background: #ffe9a8; color: #222; }
output { font-variant-numeric: tabular-nums; font-weight: bold; min-width: 7.5em; }
small { color: #5b6570; }
.gone { opacity: 0.35; }
#paths { visibility: hidden; } .traced #paths { visibility: visible; }
</style>
)html";

inline constexpr std::string_view kControls = R"html(<nav>
<button id="back" title="previous event (left arrow)">&laquo;</button>
<button id="play" title="play or pause (space)">&#9654;</button>
<button id="next" title="next event (right arrow)">&raquo;</button>
<input id="when" type="range" min="0" max="10000" value="0" aria-label="time">
<output id="clock">0 s</output>
<select id="rate" title="speed"><option value="0.02">1/50</option><option value="0.1">1/10</option>
<option value="0.25">1/4</option><option value="1" selected>1</option><option value="4">4</option></select>
<label><input id="trace" type="checkbox"> paths</label>
</nav>
)html";

// A piece is [from, to, x, y, vx, vy, ax, ay] in seconds and metres: the ball is at
// x + vx T + ax T^2 / 2 with T = t - from. An event is [time, text, balls...].
inline constexpr std::string_view kScript = R"html(<script>
"use strict";
const run = JSON.parse(document.getElementById("run").textContent);
const get = id => document.getElementById(id);
const balls = run.pieces.map((pieces, i) => ({pieces, at: 0, node: get("ball-" + i)}));
let t = 0, playing = false, last = 0;

function pieceAt(ball) {
  const p = ball.pieces;
  if (!p.length) return null;
  let low = 0, high = p.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (p[middle][0] <= t) low = middle; else high = middle - 1;
  }
  return p[low];
}
function show() {
  for (const ball of balls) {
    const p = pieceAt(ball);
    if (!p || !ball.node) continue;
    const T = Math.min(Math.max(t - p[0], 0), p[1] - p[0]);
    const x = run.origin[0] + run.scale * (p[2] + T * (p[4] + T * p[6] / 2) - run.centre[0]);
    const y = run.origin[1] - run.scale * (p[3] + T * (p[5] + T * p[7] / 2) - run.centre[1]);
    ball.node.setAttribute("transform", "translate(" + x.toFixed(2) + " " + y.toFixed(2) + ")");
    ball.node.classList.toggle("gone", p === ball.pieces[ball.pieces.length - 1] && t > p[1] && p[1] < run.end);
  }
  get("clock").textContent = t.toFixed(run.end < 0.1 ? 6 : 4) + " s";
  get("when").value = run.end > 0 ? 10000 * t / run.end : 0;
  let current = -1;
  run.events.forEach((event, i) => { if (event[0] <= t) current = i; });
  if (current !== show.current) {
    show.current = current;
    items.forEach((item, i) => {
      item.className = i === current ? "now" : i < current ? "past" : "";
      if (i === current) item.scrollIntoView({block: "nearest"});
    });
  }
}
function go(time) { t = Math.min(Math.max(time, 0), run.end); show(); }
function play(on) {
  playing = on;
  if (on && t >= run.end) t = 0;
  get("play").innerHTML = on ? "||" : "&#9654;";
  if (on) { last = performance.now(); requestAnimationFrame(frame); }
}
function frame(now) {
  if (!playing) return;
  go(t + (now - last) / 1000 * Number(get("rate").value));
  last = now;
  if (t >= run.end) play(false); else requestAnimationFrame(frame);
}
function nextEvent() { play(false); const e = run.events.find(e => e[0] > t); go(e ? e[0] : run.end); }
function previousEvent() {
  play(false);
  const before = run.events.filter(e => e[0] < t);
  go(before.length ? before[before.length - 1][0] : 0);
}
const items = run.events.map(event => {
  const item = document.createElement("li");
  item.textContent = event[0].toFixed(4) + " s  " + event[1];
  item.onclick = () => { play(false); go(event[0]); };
  get("events").append(item);
  return item;
});
get("play").onclick = () => play(!playing);
get("next").onclick = nextEvent;
get("back").onclick = previousEvent;
get("when").oninput = e => { play(false); go(e.target.value / 10000 * run.end); };
get("trace").onchange = e => document.body.classList.toggle("traced", e.target.checked);
document.onkeydown = e => {
  if (e.target.tagName === "SELECT") return;
  const keys = {" ": () => play(!playing), ArrowRight: nextEvent, ArrowLeft: previousEvent,
                Home: () => go(0), End: () => go(run.end)};
  if (keys[e.key]) { keys[e.key](); e.preventDefault(); }
};
show();
</script>
</html>
)html";

}  // namespace osculo::io::html
