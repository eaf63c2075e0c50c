#include "analysis/report/page_parts.h"

namespace promenade::analysis {

namespace {

constexpr std::string_view css = R"css(
:root { --ink: #1d2126; --quiet: #5d6670; --line: #d5d9de; --data: #0072b2; }
* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: var(--ink);
  font: 16px/1.45 "Noto Sans", "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
main { max-width: 1280px; margin: 0 auto; padding: 28px 40px 60px; }
.stripe { background: #e8780c; color: #000; padding: 10px 40px; font-size: 18px;
  font-weight: 700; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.study { margin: 0 0 6px; color: var(--quiet); }
h1 { font-size: 28px; line-height: 1.28; font-weight: 600; margin: 0 0 10px; max-width: 62ch;
  text-wrap: balance; }
h2 { font-size: 22px; margin: 44px 0 8px; border-bottom: 2px solid var(--ink); padding-bottom: 4px; }
h3, .panel h2 { font-size: 17px; margin: 0 0 10px; }
.panel h2 { border: 0; padding: 0; }
p, li { max-width: 82ch; overflow-wrap: break-word; }
.second { font-size: 19px; margin: 0 0 8px; max-width: 80ch; }
.caveat { border-left: 4px solid var(--ink); padding: 2px 0 2px 12px; margin: 8px 0; }
.flow { margin: 20px 0 26px; }
.flow .bar { display: flex; height: 30px; border: 1px solid var(--ink); }
.flow .bar span { min-width: 24px; text-align: center; line-height: 28px; font-size: 15px;
  font-weight: 600; border-right: 1px solid var(--ink); overflow: hidden; }
.flow .bar span:last-child { border-right: 0; }
.flow .analysed { background: #005a8c; color: #fff; }
.flow .excluded { background: #8fa9ba; }
.flow .unfinished { background: #c3d0d9; }
.flow .withdrawn { background: #e2e8ec; }
.flow .declined { background: #fff; }
.flow .no-show, .flow .replaced, .flow .expected { background: repeating-linear-gradient(45deg,
  #fff 0 5px, #d5d9de 5px 8px); }
.flow .expected { background: repeating-linear-gradient(45deg, #fff 0 9px, #d5d9de 9px 10px); }
.sensitivity { margin: 8px 0; }
.sensitivity a { color: var(--ink); }
.flow ul { list-style: none; display: flex; flex-wrap: wrap; gap: 4px 26px; margin: 8px 0 0;
  padding: 0; font-size: 15px; }
.flow li i { display: inline-block; width: 13px; height: 13px; border: 1px solid var(--ink);
  margin-right: 7px; vertical-align: -1px; overflow: hidden; }
.bar span, .flow li i { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.panel { display: grid; grid-template-columns: minmax(0, 1.5fr) minmax(0, 1fr); gap: 40px;
  margin: 0 0 30px; align-items: start; }
.strip { display: grid; grid-template-columns: 170px minmax(0, 1fr); gap: 14px;
  align-items: center; border-top: 1px solid var(--line); }
.strip b { display: block; overflow-wrap: anywhere; line-height: 1.2; }
.strip small { display: block; color: var(--quiet); font-size: 13.5px; line-height: 1.35; }
.strip svg { display: block; width: 100%; height: auto; }
.strip.axis { border-top: 1px solid var(--ink); }
svg text { font: 13px "Noto Sans", Arial, sans-serif; fill: var(--quiet); }
.triangle { width: 100%; border-collapse: collapse; table-layout: fixed; margin: 0; }
.triangle th { font-weight: 600; font-size: 13.5px; padding: 4px; overflow-wrap: anywhere;
  border: 0; text-align: center; vertical-align: bottom; }
.triangle th[scope=row] { text-align: right; vertical-align: middle; }
.triangle td { border: 1px solid var(--line); text-align: center; padding: 7px 3px;
  line-height: 1.3; font-size: 14px; }
.triangle td.sig { border: 2px solid var(--ink); font-weight: 700; }
.triangle caption { font-size: 17px; font-weight: 700; padding-bottom: 10px; line-height: 1.45; }
.triangle td.ns { color: #62686f; background: #f4f5f6; }
.triangle td.none { border: 0; }
.triangle td span { display: block; font-size: 13px; }
.buttons { display: flex; flex-wrap: wrap; gap: 10px; margin: 6px 0 0; padding: 0; }
.buttons a { border: 1px solid var(--ink); border-radius: 4px; padding: 7px 14px;
  color: var(--ink); text-decoration: none; font-size: 15px; }
.buttons a:hover, .buttons a:focus { background: #eef2f5; }
.contents ol { columns: 4 210px; margin: 22px 0 0; padding: 14px 0 14px 1.6em; font-size: 15px;
  border-top: 1px solid var(--line); border-bottom: 1px solid var(--line); }
.contents li { break-inside: avoid; padding: 1px 0; } .contents a { color: var(--ink); }
details { margin: 14px 0; } summary { cursor: pointer; font-size: 15px; }
.figures { display: flex; flex-wrap: wrap; gap: 28px; }
figure { margin: 0; break-inside: avoid; flex: 1 1 440px; max-width: 586px; min-width: 0; }
figure.full { flex-basis: 100%; max-width: 100%; }
figure img { display: block; width: 100%; height: auto; }
figcaption { margin-top: 6px; } figcaption .files { white-space: nowrap; }
figcaption, caption { color: var(--ink); font-size: 15px; text-align: left; padding: 0 0 8px;
  caption-side: top; }
.wide { overflow-x: auto; margin: 18px 0 30px; }
table { border-collapse: collapse; font-size: 14.5px; }
.wide table { width: 100%; border-top: 2px solid var(--ink); border-bottom: 2px solid var(--ink); }
.wide caption { padding-top: 4px; }
.wide th, .wide td { padding: 4px 9px; text-align: right; font-variant-numeric: tabular-nums;
  white-space: nowrap; }
.wide th[scope=row] { text-align: left; font-weight: 400; white-space: normal;
  overflow-wrap: anywhere; min-width: 5.5em; }
.wide thead th { border-bottom: 1px solid var(--ink); vertical-align: bottom; white-space: normal; }
.wide th.left { text-align: left; }
.wide tr.group td, .wide tr.group th { border-top: 1px solid var(--line); }
.wide tr.strong td, .wide tr.strong th { font-weight: 700; }
.text th, .text td { text-align: left; white-space: normal; overflow-wrap: anywhere; }
.text th[scope=row] { min-width: 7em; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; background: #f4f5f6; padding: 10px 14px;
  font-size: 13px; }
code { font-size: 14px; overflow-wrap: anywhere; }
.note { color: var(--quiet); font-size: 15px; }
@media (max-width: 900px) { .panel { grid-template-columns: 1fr; } main { padding: 20px; } }
@media (max-width: 600px) { .strip { grid-template-columns: 1fr; gap: 2px; padding-top: 5px; } }
@page { size: A4; margin: 15mm 13mm; }
@media print {
  body { font-size: 10pt; }
  main { padding: 0; max-width: none; }
  .stripe { padding: 5px 10px; font-size: 11pt; margin-bottom: 8px; }
  h1 { font-size: 16pt; } .second { font-size: 11pt; } h2 { font-size: 13pt; margin-top: 26px; }
  h3, .panel h2 { font-size: 9.5pt; margin: 0 0 5px; } .note { font-size: 8pt; margin: 6px 0; }
  .flow { margin: 12px 0 14px; } .flow ul, figcaption, caption { font-size: 8.5pt; }
  .panel { gap: 16px; break-inside: avoid; margin-bottom: 14px;
    grid-template-columns: minmax(0, 1.25fr) minmax(0, 1fr); }
  .strip { grid-template-columns: 118px minmax(0, 1fr); gap: 6px; font-size: 9pt; }
  .strip small { font-size: 7.5pt; }
  .wide { overflow: visible; margin: 12px 0 20px; } table { font-size: 8pt; }
  .wide th, .wide td { padding: 1.5px 4px; }
  .triangle caption { font-size: 9.5pt; padding-bottom: 5px; }
  .triangle td, .triangle th, .triangle td span { font-size: 7.5pt; padding: 3px 1px; }
  tr, figure, .flow { break-inside: avoid; } h2, h3, caption { break-after: avoid; }
  tbody tr:nth-child(-n+3) { break-before: avoid; }
  thead { display: table-header-group; }
  figure { flex: 0 0 47%; } .buttons, .contents, summary { display: none; }
  details::details-content { content-visibility: visible; block-size: auto; }
}
)css";

}  // namespace

std::string_view page_css() { return css; }

}  // namespace promenade::analysis
