#pragma once

namespace asos {

/// Style sheet and script of a report's pages.
inline constexpr const char* report_style = R"css(
:root { color-scheme: light; }
body { font: 16px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #1c1c1c;
  background: #fff; max-width: 78rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.7rem; margin: 0 0 .2rem; }
h2 { font-size: 1.35rem; margin: 2.6rem 0 .6rem; border-bottom: 1px solid #bbb; }
h3 { font-size: 1.08rem; margin: 1.8rem 0 .4rem; }
p, li { max-width: 52rem; }
.sub { color: #555; margin-top: 0; }
.note { color: #444; font-size: .88rem; }
.short { background: #f5f5f2; border-left: 4px solid #666; padding: .4rem 1.2rem .8rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .86rem; font-variant-numeric: tabular-nums;
  margin: .5rem 0 1rem; }
caption { text-align: left; color: #444; padding-bottom: .3rem; }
th, td { padding: .22rem .6rem; border-bottom: 1px solid #ddd; text-align: right;
  vertical-align: top; white-space: nowrap; }
th { border-bottom: 2px solid #888; font-weight: 600; }
th { white-space: normal; vertical-align: bottom; }
th.t, td.t { text-align: left; }
table.wide { font-size: .74rem; }
table.wide th, table.wide td { padding: .2rem .4rem; }
label, .key { white-space: nowrap; margin-right: 1rem; }
tbody th { border-bottom: 1px solid #ddd; }
td.win { color: #0b5a2b; }
td.loss { background: #fbe9e2; font-weight: 600; }
td.under, tr.under td { color: #777; font-style: italic; }
tr.first td { border-top: 2px solid #bbb; }
summary { cursor: pointer; color: #333; font-size: .9rem; margin: .4rem 0; }
a { color: #0b4a8b; }
figure { margin: .8rem 0; }
figcaption { font-size: .85rem; color: #444; }
img { max-width: 100%; }
.plot img { width: 54rem; }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(19rem, 1fr)); gap: 1rem; }
.grid img { width: 100%; image-rendering: pixelated; background: #eee; }
img.strip { width: 100%; image-rendering: pixelated; }
.slider { position: relative; width: min(100%, 48rem); }
.slider img { display: block; width: 100%; image-rendering: pixelated; }
.slider .over { position: absolute; inset: 0; clip-path: inset(0 50% 0 0); }
.slider .line { position: absolute; top: 0; bottom: 0; left: 50%; width: 2px; background: #fff;
  box-shadow: 0 0 2px #000; pointer-events: none; }
.tool input[type=range] { width: min(100%, 48rem); display: block; margin: .3rem 0; }
.chip { display: inline-block; width: .9em; height: .9em; border: 1px solid #666;
  vertical-align: -.1em; margin-right: .3em; }
.ramp { display: inline-block; width: 10em; height: .8em; border: 1px solid #666;
  vertical-align: -.05em; margin: 0 .4em; background: linear-gradient(90deg, rgb(0,0,4),
  rgb(87,16,110), rgb(188,55,84), rgb(249,142,9), rgb(252,255,164)); }
code { font-size: .92em; }
@media print {
  body { font-size: 10pt; max-width: none; padding: 0; }
  .tool { display: none; }
  h2, h3 { break-after: avoid; }
  figure, tr { break-inside: avoid; }
  .scroll { overflow: visible; }
  td.loss { border: 1px solid #000; }
  table.wide { font-size: 6.5pt; }
}
)css";

inline constexpr const char* report_script = R"js(
for (const tool of document.querySelectorAll('.tool')) {
  const pictures = document.querySelectorAll('#' + tool.dataset.pictures + ' img[data-label]');
  const [left, right] = tool.querySelectorAll('select');
  const [under, over] = tool.querySelectorAll('.slider img');
  const range = tool.querySelector('input');
  pictures.forEach((picture, i) => {
    for (const select of [left, right]) select.add(new Option(picture.dataset.label, i));
  });
  const show = () => {
    over.src = pictures[left.value].src;
    over.alt = pictures[left.value].dataset.label;
    under.src = pictures[right.value].src;
    under.alt = pictures[right.value].dataset.label;
    over.style.clipPath = `inset(0 ${100 - range.value}% 0 0)`;
    tool.querySelector('.line').style.left = range.value + '%';
  };
  left.value = Math.min(1, pictures.length - 1);
  right.value = 0;
  for (const control of [left, right, range]) control.addEventListener('input', show);
  tool.hidden = false;
  show();
}
)js";

}  // namespace asos
