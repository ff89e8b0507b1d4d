// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::inline v1 {

/// The style sheet of reports. The colours of curves c0 to c6 are Okabe and Ito's, which remain distinguishable under
/// all common kinds of colour blindness, darkened on light pages and lightened on dark ones until a thin line has
/// enough contrast.
inline constexpr const char* report_style = R"css(
:root{color-scheme:light dark;--bg:#fdfdfb;--ink:#1d2126;--soft:#5b636c;--rule:#dcdfe2;--grid:#e9ebed;--edge:#8a949e;
--bad:#a82a00;--good:#00684a;--six:#e9e7df;
--c0:#0067a3;--c1:#c04f00;--c2:#007a59;--c3:#a3518a;--c4:#8a6500;--c5:#6f55c6;--c6:#4a4f55}
@media(prefers-color-scheme:dark){:root{--bg:#15181b;--ink:#e4e7ea;--soft:#9aa4ae;--rule:#343a40;--grid:#262b30;
--edge:#6d7782;--bad:#ff9166;--good:#4ccfa2;--six:#343a40;
--c0:#5fb4ea;--c1:#f08a4b;--c2:#3fc79b;--c3:#df9cc6;--c4:#e0b64a;--c5:#b9a8f7;--c6:#b5bcc4}}
*{box-sizing:border-box}
body{margin:0;background:var(--bg);color:var(--ink);font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,
"Helvetica Neue",Arial,sans-serif;-webkit-text-size-adjust:100%}
main{max-width:1160px;margin:0 auto;padding:40px 24px 64px}
h1{font-size:1.7rem;line-height:1.2;font-weight:600;margin:0 0 10px;letter-spacing:-.01em;overflow-wrap:anywhere}
h2{font-size:1.12rem;font-weight:600;margin:52px 0 14px;padding-top:14px;border-top:1px solid var(--rule)}
h3{font-size:.95rem;font-weight:600;margin:0 0 6px}
p{margin:0 0 10px;max-width:46em}
.terms{max-width:46em;margin:0 0 10px}.terms dt{font-weight:600}.terms dd{margin:0 0 8px}
a{color:var(--c0)}
code{font:.86em/1.5 ui-monospace,"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace;overflow-wrap:anywhere}
.command{color:var(--soft);margin-bottom:24px}
.verdict{font-weight:600}.bad{color:var(--bad)}.good{color:var(--good)}
.numbers{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,310px),1fr));gap:0 44px;align-items:start}
.numbers>table:only-child{max-width:560px}
.scroll{overflow-x:auto;background:linear-gradient(270deg,var(--bg) 30%,transparent) 100% 0/40px 100% local,
linear-gradient(270deg,var(--rule),transparent) 100% 0/12px 100% scroll;background-repeat:no-repeat}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{padding:6px 0;border-bottom:1px solid var(--rule);text-align:left;vertical-align:baseline;font-weight:400}
.numbers th{color:var(--soft)}.numbers td{text-align:right;white-space:nowrap}.numbers .long{white-space:normal}
.wide th,.wide td{padding:6px 9px;text-align:right;white-space:nowrap}
.wide{font-size:.93rem}
.wide th:first-child{text-align:left;padding-left:0;position:sticky;left:0;background:var(--bg);white-space:normal;
min-width:8.5em}
.wide thead th{color:var(--soft);font-size:.88rem;white-space:normal}
.wide th:last-child,.wide td:last-child{padding-right:0}
.claims{min-width:860px;font-size:.93rem}.claims th,.claims td{padding:9px 14px 9px 0;vertical-align:top;width:20%}
.claims :nth-child(2){width:9%}.claims thead th{color:var(--soft);font-size:.88rem}
.sortable button{all:unset;cursor:pointer}
.sortable button:hover,.sortable [aria-sort] button{color:var(--ink)}
.sortable button:focus-visible{outline:2px solid var(--c0);outline-offset:3px}
.sortable [aria-sort] button::after{content:" ↑"}.sortable [aria-sort=descending] button::after{content:" ↓"}
small{color:var(--soft);font-size:.86em}
.panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,440px),1fr));gap:28px 40px}
figure{margin:0;min-width:0}
figcaption{color:var(--soft);font-size:.88rem;line-height:1.45;margin-top:8px;max-width:46em}
svg{display:block;width:100%;height:auto}
.panels>figure:only-child{max-width:620px}
.mesh{border:1px solid var(--rule)}
.film{max-width:760px}.film input{width:100%}.film [hidden]{display:none}
.finding{font-size:1.08rem;line-height:1.5;max-width:44em}
.keys{color:var(--soft);font-size:.88rem;max-width:none}.keys span{white-space:nowrap;margin-right:.9em}
.key{display:inline-block;width:1.05em;height:1.05em;margin-right:.35em;vertical-align:-.15em}
.key .face{stroke-width:.6}
.face{stroke:var(--edge);stroke-linejoin:round}
.n0{fill:#8c3300}.n1{fill:#ef8f4d}.n2{fill:var(--six)}.n3{fill:#6db3e3}.n4{fill:#0b5c94}.n5{fill:var(--bg)}
.q0{fill:#c02f20}.q1{fill:#f0915f}.q2{fill:#fbd9a3}.q3{fill:#cfe3ee}.q4{fill:#74b0d6}.q5{fill:#2f74b0}
.edges,.outline,.dots,.halo,.curve,.lead,.grid,.tick,.axis{fill:none}
.edges{stroke:var(--edge);stroke-linejoin:round}.dots,.halo{stroke-linecap:round}
.outline{stroke:var(--ink)}.dots{stroke:var(--c0)}.halo{stroke:var(--bg)}
.grid{stroke:var(--grid)}.tick,.axis{stroke:var(--soft)}
.curve{stroke-width:2;stroke-linejoin:round;stroke-linecap:round}
.lead{stroke-width:.8;opacity:.55;stroke-dasharray:none!important}
.bar{fill:none;stroke-width:1.4;stroke-dasharray:none!important}
.plot text{font-size:13px;fill:var(--soft)}
.plot .al{font-size:13.5px;fill:var(--ink)}
.plot .name{font-weight:600;paint-order:stroke;stroke:var(--bg);stroke-width:4px;stroke-linejoin:round;
stroke-dasharray:none!important}
.m{text-anchor:middle}.e{text-anchor:end}
.c0{stroke:var(--c0)}.c1{stroke:var(--c1);stroke-dasharray:9 4}.c2{stroke:var(--c2);stroke-dasharray:2 4.5}
.c3{stroke:var(--c3);stroke-dasharray:11 4 2 4}.c4{stroke:var(--c4);stroke-dasharray:5 3}.c5{stroke:var(--c5)}
.c6{stroke:var(--c6);stroke-dasharray:14 5}
.again{stroke-dasharray:13 3 2 3 2 3}
.plot .name.c0{fill:var(--c0)}.plot .name.c1{fill:var(--c1)}.plot .name.c2{fill:var(--c2)}
.plot .name.c3{fill:var(--c3)}.plot .name.c4{fill:var(--c4)}.plot .name.c5{fill:var(--c5)}.plot .name.c6{fill:var(--c6)}
@media(max-width:600px){main{padding:24px 14px 40px}h1{font-size:1.35rem}.panels{gap:24px})css"
                                            R"css(.plot .tl,.plot .al{font-size:15px}}
@media(max-width:900px){.claims,.claims tbody{display:block;min-width:0}.claims thead{display:none}
.claims tr{display:flex;flex-direction:column;border-bottom:1px solid var(--rule);padding:9px 0}
.claims :nth-child(n){width:auto}.claims th,.claims td{border:0;padding:2px 0}.claims th{order:-2}
.claims td:last-child{display:contents}.claims td>span{order:-1}.claims td>small{order:1}
.claims td>span::before{content:"Verdict: ";color:var(--soft)}
.claims td:nth-child(2)::before{content:"The paper: "}.claims td:nth-child(3)::before{content:"Under its algorithm: "}
.claims td:nth-child(4)::before{content:"Under ours: "}.claims td::before{color:var(--soft)}}
@media(max-width:600px){.wide th:first-child{min-width:6em}.wide td:last-child{white-space:normal;min-width:6em}}
@media print{:root{--bg:#fff}main{padding:0}h2{break-after:avoid}figure{break-inside:avoid}}
)css";

}  // namespace annulus::inline v1
