"use strict";
// Search in the report, and a filter of its cards by grade and chapter. Both are in the address, so that a link keeps
// them.
{
  const MOST_RESULTS = 40;
  const articles = [...document.querySelectorAll("article.claim")];
  const hideable = [...document.querySelectorAll("section.group, section.chapter")];
  document.querySelector(".sidebar").prepend(document.getElementById("claim-tools").content.cloneNode(true));
  const tools = document.querySelector("search.tools");
  const form = tools.querySelector("form");
  const { query, chapter } = form.elements;
  const boxes = [...form.querySelectorAll("input[name=grade]")];
  const filters = form.querySelector("details.filters");
  const state = form.querySelector("output");
  const reset = form.querySelector("button[type=reset]");
  const results = tools.querySelector(".results");
  const hint = tools.querySelector(".hint");

  const wanted = () => ({
    terms: search.terms(query.value),
    grades: boxes.filter((box) => box.checked).map((box) => box.value),
    chapter: chapter.value,
  });
  const isFiltering = ({ grades, chapter: only }) => grades.length < boxes.length || only !== "";
  const isFiltered = (wish) => wish.terms.length > 0 || isFiltering(wish);

  // Cards obey the filter; what is no card is found by words alone.
  const obeys = ({ card }, wish) => (card
    ? wish.grades.includes(card.dataset.grade) && (wish.chapter === "" || wish.chapter === card.dataset.chapter)
    : wish.terms.length > 0 && !isFiltering(wish));
  const fitting = (wish) => {
    const ranks = new Map();
    for (const entry of search.entries()) {
      const rank = obeys(entry, wish) ? (wish.terms.length === 0 ? 0 : search.rank(entry, wish.terms)) : undefined;
      if (rank !== undefined) ranks.set(entry, rank);
    }
    return [...ranks.keys()].sort((one, other) => ranks.get(one) - ranks.get(other));
  };

  const made = (name, className, text) => Object.assign(document.createElement(name), { className, textContent: text });
  const list = (found) => {
    results.replaceChildren(...found.slice(0, MOST_RESULTS).map(({ id, heading, card, place }) => {
      const item = document.createElement("li");
      const link = Object.assign(made("a", "", heading), { href: `#${id}` });
      item.append(link, card ? card.querySelector(".meta .badge").cloneNode(true) : made("span", "place", place ?? "section"));
      return item;
    }));
    if (found.length > MOST_RESULTS) results.append(made("li", "", `and ${found.length - MOST_RESULTS} more in the report`));
  };

  // What a reader may do who has found nothing.
  const advice = (wish) => {
    const lines = [`Nothing has “${query.value.trim()}”.`];
    const whole = { ...wish, grades: boxes.map((box) => box.value), chapter: "" };
    const hidden = isFiltering(wish) ? fitting(whole).length : 0;
    if (hidden > 0) lines.push(`The filter hides ${hidden} places that have it.`);
    const missing = wish.terms.filter((term) => !search.entries().some((entry) => search.isThere(entry, term)));
    if (wish.terms.length > 1) {
      lines.push(missing.length > 0 ? `No place has ${missing.map(({ said }) => `“${said}”`).join(" or ")}.`
        : "Each word is there, but no place has all of them.");
    }
    lines.push("Fewer words find more. Numbers may be written as 733.6, 2e-8 or 2·10^-8, an equation as (5.13).");
    return lines.join(" ");
  };

  const show = () => {
    const wish = wanted();
    const found = isFiltered(wish) ? fitting(wish) : [];
    const cards = found.filter(({ card }) => card);
    const kept = new Set(isFiltered(wish) ? cards.map(({ card }) => card) : articles);
    for (const article of articles) article.hidden = !kept.has(article);
    for (const section of hideable) section.hidden = !section.querySelector("article.claim:not([hidden])");
    const others = found.length - cards.length;
    const elsewhere = others > 0 ? `, ${others} other place${others === 1 ? "" : "s"}` : "";
    state.textContent = `${isFiltered(wish) ? `${kept.size} of ` : ""}${articles.length} claims`
      + (isFiltered(wish) ? ` shown${elsewhere}` : "");
    reset.hidden = !isFiltered(wish);
    results.hidden = found.length === 0;
    list(found);
    hint.hidden = wish.terms.length === 0 || found.length > 0;
    hint.textContent = hint.hidden ? "" : advice(wish);
    search.mark(wish.terms.length > 0 ? found : [], wish.terms);
  };

  const remember = () => {
    const wish = wanted();
    const address = new URLSearchParams();
    if (wish.terms.length > 0) address.set("query", query.value.trim());
    if (wish.grades.length < boxes.length) address.set("grade", wish.grades.join(","));
    if (wish.chapter) address.set("chapter", wish.chapter);
    const text = address.toString().replaceAll("%2C", ",");
    history.replaceState(null, "", `${location.pathname}${text ? `?${text}` : ""}${location.hash}`);
  };

  const choose = (text) => {
    const address = new URLSearchParams(text);
    const named = (address.get("grade") ?? "").split(",");
    const known = boxes.some((box) => named.includes(box.value));
    for (const box of boxes) box.checked = !known || named.includes(box.value);
    const number = address.get("chapter") ?? "";
    chapter.value = [...chapter.options].some((option) => option.value === number) ? number : "";
    query.value = address.get("query") ?? "";
    if (known || chapter.value) filters.open = true;
    show();
  };

  // A link to what the filter hides shows everything again; the identifiers are plain ASCII.
  const reveal = () => {
    const target = document.getElementById(location.hash.slice(1));
    if (target?.closest("[hidden]")) {
      choose("");
      remember();
      target.scrollIntoView();
    }
  };

  form.addEventListener("input", () => { show(); remember(); });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    results.querySelector("a")?.click();
  });
  form.addEventListener("reset", () => setTimeout(() => { choose(""); remember(); }));
  document.addEventListener("click", (event) => {
    const link = event.target.closest("a[data-filter]");
    if (link) { choose(link.dataset.filter); setTimeout(remember); }
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && !event.target.closest("input, select, textarea")) {
      event.preventDefault();
      query.focus();
    }
  });
  query.addEventListener("focus", () => setTimeout(search.entries), { once: true }); // so that the first letter need not wait
  addEventListener("hashchange", reveal);
  choose(location.search);
  reveal();
}
