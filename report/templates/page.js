"use strict";
{
  const claims = [...document.querySelectorAll("article.claim")];
  const chapters = [...document.querySelectorAll("section.chapter")];
  const box = document.querySelector(".filter");

  const element = (name, properties, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  };

  // ---- filter -----------------------------------------------------------------------------------------------
  const order = ["reproduced", "explained", "not-checkable", "erratum"];
  const present = new Set(claims.map((claim) => claim.dataset.verdict));
  const verdicts = order.filter((verdict) => present.has(verdict));

  const boxes = verdicts.map((verdict) =>
    element("input", { type: "checkbox", name: "verdict", value: verdict, checked: true }));
  const select = element("select", { name: "chapter" },
    new Option("all chapters", ""),
    ...chapters.map((chapter) => new Option(chapter.querySelector("h3").textContent, chapter.dataset.chapter)));
  const reset = element("button", { type: "reset", textContent: "Show all" });
  const state = element("output", {});
  const form = element("form", {},
    element("fieldset", {}, element("legend", { textContent: "Verdict" }),
      ...boxes.map((input) => element("label", {}, input, ` ${input.value}`))),
    element("label", {}, element("strong", { textContent: "Chapter " }), select),
    reset);

  const wanted = () => ({
    verdicts: new Set(boxes.filter((input) => input.checked).map((input) => input.value)),
    chapter: select.value,
  });

  const show = () => {
    const { verdicts: chosen, chapter } = wanted();
    for (const claim of claims) {
      claim.hidden = !chosen.has(claim.dataset.verdict) || (chapter !== "" && claim.dataset.chapter !== chapter);
    }
    for (const section of chapters) {
      section.hidden = !section.querySelector("article.claim:not([hidden])");
    }
    const shown = claims.filter((claim) => !claim.hidden).length;
    state.textContent = `${shown} of ${claims.length} claims shown`;
  };

  const remember = () => {
    const { verdicts: chosen, chapter } = wanted();
    const query = new URLSearchParams();
    if (chosen.size < boxes.length) query.set("verdict", [...chosen].join(","));
    if (chapter) query.set("chapter", chapter);
    const text = query.toString().replaceAll("%2C", ",");
    history.replaceState(null, "", `${location.pathname}${text ? `?${text}` : ""}${location.hash}`);
  };

  const choose = (text) => {
    const query = new URLSearchParams(text);
    const named = (query.get("verdict") ?? "").split(",").filter((verdict) => verdicts.includes(verdict));
    const chosen = named.length > 0 ? named : verdicts;
    for (const input of boxes) input.checked = chosen.includes(input.value);
    const chapter = query.get("chapter") ?? "";
    select.value = [...select.options].some((option) => option.value === chapter) ? chapter : "";
    show();
  };

  // A link to a claim that the filter hides shows everything again; the identifiers are plain ASCII.
  const reveal = () => {
    const target = document.getElementById(location.hash.slice(1));
    if (target?.closest("[hidden]")) {
      choose("");
      remember();
      target.scrollIntoView();
    }
  };

  form.addEventListener("change", () => { show(); remember(); });
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("reset", () => setTimeout(() => { choose(""); remember(); }));
  document.addEventListener("click", (event) => {
    const link = event.target.closest("a[data-filter]");
    if (link) { choose(link.dataset.filter); setTimeout(remember); }
  });
  addEventListener("hashchange", reveal);
  box.append(form, state);
  choose(location.search);
  reveal();

  // ---- copying of LaTeX -------------------------------------------------------------------------------------
  for (const source of document.querySelectorAll(".source")) {
    const button = element("button", { type: "button", textContent: "Copy" });
    button.addEventListener("click", async () => {
      const code = source.querySelector("code");
      try {
        await navigator.clipboard.writeText(code.textContent);
        button.textContent = "Copied";
      } catch { // no clipboard without HTTPS, or not allowed: the reader copies the selection
        getSelection().selectAllChildren(code);
        button.textContent = "Selected";
      }
      setTimeout(() => { button.textContent = "Copy"; }, 1500);
    });
    source.querySelector("figcaption").append(button);
  }

  // ---- contents: closed where they would push the report off a narrow screen ---------------------------------
  const contents = document.querySelector("nav details");
  const wide = matchMedia("(min-width: 64rem)");
  const fold = () => { contents.open = wide.matches; };
  wide.addEventListener("change", fold);
  fold();
}
