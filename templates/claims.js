"use strict";
// Search in the claims, and a filter by grade and chapter. Both are in the address, so that a link keeps them.
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

  const plain = (text) => text.normalize("NFKD").replace(/[\u0300-\u036f]/g, "").replace(/\u2212/g, "-")
    .replace(/\s+/g, " ").toLowerCase();

  let claims; // made when it is first needed: the text of all claims is long
  const index = () => claims ??= articles.map((article) => {
    const heading = article.querySelector("h3, h4").textContent;
    return { article, heading, id: article.id.toLowerCase(), title: plain(heading), text: plain(article.textContent) };
  });

  // The better a claim fits, the smaller its rank; a claim that lacks a word has none.
  const rank = (claim, words) => {
    if (!words.every((word) => claim.text.includes(word) || claim.id.includes(word))) return undefined;
    const phrase = words.join(" ");
    if (claim.id === phrase || claim.title.startsWith(`${phrase}:`)) return 0;
    if (words.every((word) => claim.title.includes(word) || claim.id.includes(word))) return 1;
    return 2;
  };

  const wanted = () => ({
    words: plain(query.value).split(" ").filter(Boolean),
    grades: boxes.filter((box) => box.checked).map((box) => box.value),
    chapter: chapter.value,
  });
  const isFiltered = ({ words, grades, chapter: only }) =>
    words.length > 0 || grades.length < boxes.length || only !== "";

  const list = (found) => {
    results.replaceChildren(...found.slice(0, MOST_RESULTS).map(({ article, heading }) => {
      const entry = document.createElement("li");
      const link = document.createElement("a");
      link.href = `#${article.id}`;
      link.textContent = heading;
      entry.append(link, article.querySelector(".meta .badge").cloneNode(true));
      return entry;
    }));
    if (found.length > MOST_RESULTS) {
      const rest = document.createElement("li");
      rest.textContent = `and ${found.length - MOST_RESULTS} more in the report`;
      results.append(rest);
    }
  };

  const show = () => {
    const wish = wanted();
    const ranks = new Map();
    for (const claim of isFiltered(wish) ? index() : []) {
      const { grade, chapter: number } = claim.article.dataset;
      const fits = wish.grades.includes(grade) && (wish.chapter === "" || wish.chapter === number);
      const rankOfClaim = fits ? rank(claim, wish.words) : undefined;
      if (rankOfClaim !== undefined) ranks.set(claim, rankOfClaim);
    }
    const found = [...ranks.keys()].sort((one, other) => ranks.get(one) - ranks.get(other));
    const kept = new Set(isFiltered(wish) ? found.map(({ article }) => article) : articles);
    for (const article of articles) article.hidden = !kept.has(article);
    for (const section of hideable) section.hidden = !section.querySelector("article.claim:not([hidden])");
    state.textContent = isFiltered(wish) ? `${kept.size} of ${articles.length} claims shown` : `${articles.length} claims`;
    reset.hidden = !isFiltered(wish);
    results.hidden = !isFiltered(wish) || found.length === 0;
    list(found);
  };

  const remember = () => {
    const wish = wanted();
    const search = new URLSearchParams();
    if (wish.words.length > 0) search.set("query", query.value.trim());
    if (wish.grades.length < boxes.length) search.set("grade", wish.grades.join(","));
    if (wish.chapter) search.set("chapter", wish.chapter);
    const text = search.toString().replaceAll("%2C", ",");
    history.replaceState(null, "", `${location.pathname}${text ? `?${text}` : ""}${location.hash}`);
  };

  const choose = (text) => {
    const search = new URLSearchParams(text);
    const named = (search.get("grade") ?? "").split(",");
    const known = boxes.some((box) => named.includes(box.value));
    for (const box of boxes) box.checked = !known || named.includes(box.value);
    const number = search.get("chapter") ?? "";
    chapter.value = [...chapter.options].some((option) => option.value === number) ? number : "";
    query.value = search.get("query") ?? "";
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
  addEventListener("hashchange", reveal);
  choose(location.search);
  reveal();
}
