#pragma once

namespace ricochet::console {

/// The one style sheet of all pages. Sizes follow the reader's font size; wide screens get larger type, not longer
/// lines.
inline constexpr const char* page_style = R"css(
:root{color-scheme:light dark;--ground:#fbfaf8;--sheet:#fff;--ink:#1d2026;--soft:#555b66;--line:#d9d7d1;--link:#0a569b;
--pass:#17633a;--fail:#a3161b;--mark:#f3f1ec;--shade:#0003}
@media (prefers-color-scheme:dark){:root{--ground:#121418;--sheet:#1b1e24;--ink:#e4e6ea;--soft:#a9b0bc;--line:#363b45;
--link:#8fc7f7;--pass:#83d7a6;--fail:#ff9b93;--mark:#23272f;--shade:#fff4}}
*{box-sizing:border-box}
html{font-size:clamp(16px,.55vw + 10px,28px);scroll-behavior:auto;-webkit-text-size-adjust:100%}
body{margin:0;background:var(--ground);color:var(--ink);font:1rem/1.55 system-ui,"DejaVu Sans",sans-serif;
  overflow-wrap:anywhere}
h1,h2,h3{font-family:"Iowan Old Style","Palatino Linotype",Palatino,"Book Antiqua",Georgia,"DejaVu Serif",serif;
font-weight:600;line-height:1.2;text-wrap:balance}
h1{font-size:clamp(1.7rem,4vw,2.4rem);margin:0 0 .5rem}
h2{font-size:1.5rem;margin:3.5rem 0 .75rem;padding-top:1.25rem;border-top:1px solid var(--line)}
h3{font-size:1.1rem;margin:2rem 0 .5rem}
header,main,footer{max-width:72rem;margin:0 auto;padding:0 clamp(.9rem,3vw,2rem)}
header{padding-top:clamp(1.5rem,5vw,3.5rem)}
footer{padding-top:2rem;padding-bottom:3rem;color:var(--soft);font-size:.9rem}
p,li,dd{max-width:46rem}
p{margin:.6rem 0}
a{color:var(--link);text-underline-offset:.15em}
a:focus-visible,button:focus-visible,summary:focus-visible,[tabindex]:focus-visible{outline:3px solid var(--link);
  outline-offset:2px}
.skip{position:absolute;left:-100vw}
.skip:focus{left:1rem;top:.5rem;background:var(--sheet);padding:.4rem .8rem;z-index:1}
.lead{font-size:1.2rem}
.soft{color:var(--soft)}
.facts{display:grid;grid-template-columns:max-content 1fr;gap:.15rem 1rem;margin:1rem 0;font-size:.93rem}
.facts dt{color:var(--soft)}
.facts dd{margin:0}
.verdict{border-left:.25rem solid var(--line);padding:.1rem 0 .1rem .9rem;font-size:1.08rem}
.status{font-weight:650;white-space:nowrap}
.pass{color:var(--pass)}.fail{color:var(--fail)}
.pass::before{content:"\2713\00a0"}.fail::before{content:"\2717\00a0"}
sup,sub{line-height:0;font-size:.75em}
.back{margin-top:1.5rem}
.contents{padding:0 clamp(.9rem,3vw,2rem);font-size:.93rem}
@media (min-width:75em){.beside{display:grid;grid-template-columns:minmax(13rem,17rem) minmax(0,1fr);max-width:92rem;
  margin:0 auto}
.beside>*{grid-column:2;margin:0;width:100%}
.contents{grid-column:1;grid-row:1/span 3;position:sticky;top:0;max-height:100vh;overflow-y:auto;align-self:start;
  padding-top:3.5rem}
.contents ul{display:block}.back{display:none}}
nav ul{list-style:none;margin:.8rem 0;padding:0;display:flex;flex-wrap:wrap;gap:.25rem 1.2rem}
nav a{display:inline-block;padding:.2rem 0}
.scroll{overflow-x:auto;width:fit-content;max-width:100%;margin:1rem 0 .4rem;border:1px solid var(--line);
  border-radius:.3rem;
  background:linear-gradient(to right,var(--sheet) 40%,transparent) left/2.5rem 100% no-repeat local,
  linear-gradient(to left,var(--sheet) 40%,transparent) right/2.5rem 100% no-repeat local,
  linear-gradient(to right,var(--shade),transparent) left/.9rem 100% no-repeat,
  linear-gradient(to left,var(--shade),transparent) right/.9rem 100% no-repeat,var(--sheet)}
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums;line-height:1.35;
  min-width:min(100%,24rem)}
caption{text-align:left;font-weight:600;padding:.7rem .8rem .5rem;position:sticky;left:0;max-width:calc(100vw - 2.5rem)}
th,td{padding:.32rem .8rem;text-align:left;vertical-align:top;border-top:1px solid var(--line);overflow-wrap:normal}
td.wide,th.wide{min-width:16rem;max-width:34rem;white-space:normal}
th{font-weight:600}
tbody th{font-weight:500}
thead th{background:var(--mark);vertical-align:bottom}
td,th.n{white-space:nowrap}
.n{text-align:right}
.unit{display:block;font-weight:400;color:var(--soft);font-size:.85em}
.under{font-size:.88rem;color:var(--soft);margin:.3rem 0}
details{margin:.5rem 0}
summary{cursor:pointer;color:var(--link);padding:.2rem 0}
figure{margin:1.6rem 0}
figure img{display:block;width:100%;height:auto}
figure picture{display:block;background:var(--sheet);border:1px solid var(--line);border-radius:.3rem;padding:.5rem}
figcaption{font-size:.93rem;margin-top:.5rem;max-width:46rem}
.code{position:relative;margin:.6rem 0 1.2rem}
pre{margin:0;padding:.9rem 1rem;overflow:auto;max-height:32rem;background:var(--sheet);border:1px solid var(--line);
  border-radius:.3rem;
font:.85rem/1.45 ui-monospace,"DejaVu Sans Mono",monospace;overflow-wrap:normal}
.code .bar{display:flex;justify-content:space-between;align-items:center;gap:1rem;margin-bottom:.3rem}
button{font:inherit;font-size:.88rem;padding:.25rem .9rem;color:var(--ink);background:var(--mark);
  border:1px solid var(--soft);
border-radius:.3rem;cursor:pointer;white-space:nowrap;min-width:5.2rem}
td button{margin-left:.4rem;padding:0 .3rem;min-width:3.9rem}
.own{display:none}
@media (max-width:40rem){figure img{max-width:30rem;margin:0 auto}
.stacks,.stacks caption,.stacks tbody,.stacks tr,.stacks td,.stacks tbody th{display:block}
.stacks thead{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
.stacks tr{border-top:1px solid var(--line);padding:.45rem 0}
.stacks td,.stacks tbody th{border:0;padding:.05rem .8rem;min-width:0;max-width:none;text-align:left;white-space:normal;
  overflow-wrap:anywhere}
.stacks td.n{display:inline-block}
.stacks td:empty{display:none}
.own{display:inline;color:var(--soft)}}
@media (max-width:30rem){.facts{grid-template-columns:1fr}.facts dt{margin-top:.4rem}}
@media print{:root{color-scheme:light;--ground:#fff;--sheet:#fff;--ink:#000;--soft:#444;--line:#bbb;--link:#000;
  --pass:#000;--fail:#000;--mark:#eee}
html{font-size:10pt}.skip,button,nav{display:none}figure,tr{break-inside:avoid}h2,h3,caption{break-after:avoid}
.scroll,pre{overflow:visible;max-height:none}pre{white-space:pre-wrap}}
)css";

/// Copying: without permission to use the clipboard the text is selected and can be copied by hand. A link to what is
/// folded opens it.
inline constexpr const char* page_script = R"js(
{
  const status=document.createElement('div');
  status.setAttribute('role','status');
  status.className='skip';
  document.body.append(status);
  const reveal=element=>{const closed=element?.closest('details');if(closed)closed.open=true};
  const label=(button,words)=>{
    button.setAttribute('aria-label',button.getAttribute('aria-label').replace(button.textContent,words));
    button.textContent=words;
  };
  const say=(button,words)=>{
    label(button,words);
    status.textContent=words;
    setTimeout(()=>{label(button,'Copy');status.textContent=''},2500);
  };
  for(const button of document.querySelectorAll('button[data-copy]')){
    button.hidden=false;
    button.addEventListener('click',async()=>{
      const code=document.getElementById(button.dataset.copy);
      try{await navigator.clipboard.writeText(code.textContent);say(button,'Copied')}
      catch{reveal(code);getSelection().selectAllChildren(code);say(button,'Selected: press Ctrl+C')}
    });
  }
  const follow=()=>reveal(document.getElementById(location.hash.slice(1)));
  addEventListener('hashchange',follow);
  follow();
}
)js";

}  // namespace ricochet::console
