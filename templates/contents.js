"use strict";
// The table of contents marks where the reader is, and unfolds the chapter that is being read.
{
  const nav = document.querySelector("nav");
  const details = nav.querySelector("details");
  const entries = [...nav.querySelectorAll("a")].map((link) => ({
    link,
    target: document.getElementById(link.hash.slice(1)),
  }));
  nav.classList.add("following");

  let current;
  const mark = (entry) => {
    if (entry === current) return;
    for (const item of nav.querySelectorAll(".current")) item.classList.remove("current");
    current?.link.removeAttribute("aria-current");
    current = entry;
    entry.link.setAttribute("aria-current", "true");
    for (let item = entry.link.closest("li"); item; item = item.parentElement.closest("li")) item.classList.add("current");
    const [box, around] = [entry.link.getBoundingClientRect(), nav.getBoundingClientRect()];
    if (box.top < around.top || box.bottom > around.bottom) {
      nav.scrollTop += box.top - around.top - around.height / 3; // of the contents only, not of the page
    }
  };

  // A place is being read from when its heading is as high as a link brings it; at the end, it is the last place.
  const follow = () => {
    const root = document.documentElement;
    const line = parseFloat(getComputedStyle(root).scrollPaddingTop) + 32;
    const atEnd = scrollY + innerHeight >= root.scrollHeight - 2 && scrollY > 0;
    const seen = entries.filter(({ target }) => target.offsetParent);
    const begun = seen.filter(({ target }) => atEnd || target.getBoundingClientRect().top <= line);
    mark(begun.at(-1) ?? entries[0]);
  };

  let waiting = false;
  const soon = () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; follow(); });
  };
  addEventListener("scroll", soon, { passive: true });
  addEventListener("resize", soon);

  // Contents and filter are open beside the report, closed where they would push it off a narrow screen.
  const wide = matchMedia("(min-width: 64rem)");
  const filters = document.querySelector("details.filters");
  const fold = () => { for (const each of [details, filters]) if (each) each.open = wide.matches; };
  wide.addEventListener("change", fold);
  fold();
  if (entries.length > 0) follow();
}
