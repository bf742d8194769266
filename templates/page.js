"use strict";
// Colours, copying of LaTeX, printing of the errata sheet, and boxes that scroll.
{
  const root = document.documentElement;
  const button = (text) => Object.assign(document.createElement("button"), { type: "button", textContent: text });

  document.querySelector("header.title").append(document.getElementById("theme-switch").content.cloneNode(true));
  const theme = document.querySelector("select[name=theme]");
  theme.value = root.dataset.theme ?? "";
  theme.addEventListener("change", () => {
    if (theme.value) root.dataset.theme = theme.value; else delete root.dataset.theme;
    try { localStorage.setItem("trimmer-report-theme", theme.value); } catch { } // not remembered, but shown
  });

  for (const source of document.querySelectorAll(".source")) {
    const copy = button("Copy");
    copy.addEventListener("click", async () => {
      const code = source.querySelector("code");
      try {
        await navigator.clipboard.writeText(code.textContent);
        copy.textContent = "Copied";
      } catch { // no clipboard without HTTPS, or not allowed: the reader copies the selection
        getSelection().selectAllChildren(code);
        copy.textContent = "Selected";
      }
      setTimeout(() => { copy.textContent = "Copy"; }, 1500);
    });
    source.querySelector("figcaption").append(copy);
  }

  const sheet = document.querySelector(".errata-sheet");
  if (sheet) {
    const print = button("Print this sheet alone");
    print.className = "print-sheet";
    print.addEventListener("click", () => {
      root.dataset.print = "errata";
      window.print();
    });
    addEventListener("afterprint", () => { delete root.dataset.print; });
    const past = Object.assign(document.createElement("a"), { className: "skip", href: "#after-errata",
      textContent: "Skip the errata sheet" });
    const after = Object.assign(document.createElement("div"), { id: "after-errata", tabIndex: -1 });
    sheet.querySelector("h2").after(past, print);
    sheet.after(after);
  }

  // What scrolls sideways can be reached by keyboard, what does not is no stop on the way. The content is watched
  // too: it grows when the font of formulas is there.
  const boxes = ".formula, .table-box, .picture, .paper";
  const scrollers = new ResizeObserver((changes) => {
    for (const box of new Set(changes.map(({ target }) => target.closest(boxes)))) {
      if (box.matches(".stop")) continue; // which it is in any case
      if (box.scrollWidth > box.clientWidth) box.tabIndex = 0; else if (!box.matches(".paper")) box.removeAttribute("tabindex");
    }
  });
  for (const box of document.querySelectorAll(boxes)) {
    scrollers.observe(box);
    scrollers.observe(box.firstElementChild);
  }
}
