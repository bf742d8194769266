"use strict";
// What is searched, how a query is read, and where its words stand. Searched are the cards, every other part of the
// report with a heading and an address, and every row of a table outside of the cards.
const search = (() => {
  const BY_HAND = 60; // most places whose hits are marked
  const OUTSIDE = "article.claim, .errata-sheet, .sources";
  // Words that readers use, and those that the report has for the same.
  const SAME = [
    ["dead zone", "dead-zone", "deadzone", "dead band", "deadband"],
    ["lost motion", "free play", "slack", "clearance", "backlash"],
    ["self-excited", "self-sustained", "self-oscillation"],
    ["df", "describing function"],
    ["spectrum", "fft"],
    ["nullcline", "isocline"],
  ];
  // A number in any of its ways of writing: 2e-8, 2·10^-8, 2 × 10⁻⁸, 2 \times 10^{-8}, 0.00000002.
  const NUMBER = /(\d+(?:\.\d+)?)(?:\s*(?:[×·*]|\\times|\\cdot)\s*10\s*\^?\s*\{?\s*(-?\d{1,3})\}?|e([-+]?\d{1,3})(?!\w))?/g;
  const REFERENCE = /^\(?((?:\d+|[a-e])(?:\.\d+)+)\)?$/;

  const plain = (text) => text.normalize("NFKD").replace(/[\u0300-\u036f\u2060]/g, "").replace(/[\u2212\u2010\u2011]/g, "-")
    .replace(/\s+/g, " ").toLowerCase();

  const canonical = (mantissa, power = "0") => String(Number(`${mantissa}e${power}`));
  const values = (text) => new Set([...text.matchAll(NUMBER)].map(([, mantissa, power, short]) => canonical(mantissa, power ?? short)));

  // The text without the TeX that a formula carries, with a space between elements.
  const UNSEEN = /^(annotation|svg|script|style)$/;
  const textOf = (element, left = UNSEEN) => {
    const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT | NodeFilter.SHOW_ELEMENT, (node) =>
      (node.nodeType === Node.ELEMENT_NODE && left.test(node.localName) ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT));
    const parts = [];
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (node.nodeType === Node.TEXT_NODE) parts.push(node.data);
      else if (/^(p|td|th|tr|li|h\d|div|math|summary|dt|dd|figcaption)$/.test(node.localName)) parts.push(" ");
    }
    return parts.join("");
  };

  const entry = (elements, heading, id, more, left = UNSEEN) => {
    const text = plain(elements.map((element) => textOf(element, left)).join(" "));
    let found;
    return { elements, heading, id, search: id.toLowerCase(), title: plain(heading), text, ...more,
      get values() { return found ??= values(text); } };
  };
  const cards = () => [...document.querySelectorAll("article.claim")].map((card) =>
    entry([card], textOf(card.querySelector("h3, h4")).trim(), card.id, { card }));

  const chapterOf = (element) => {
    const chapters = [...document.querySelectorAll("main h2[id]")];
    return chapters.findLast((each) => each.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING);
  };
  const sections = () => [...document.querySelectorAll("main :is(h2, h3, h4)[id]")].filter((heading) => !heading.closest(OUTSIDE))
    .map((heading) => {
      const below = [heading];
      for (let next = heading.nextElementSibling; next && !/^(H[1-4]|SECTION|ARTICLE)$/.test(next.tagName); next = next.nextElementSibling) {
        below.push(next);
      }
      const chapter = heading.localName === "h2" ? undefined : chapterOf(heading);
      const place = chapter && textOf(chapter).trim();
      return entry(below, textOf(heading).trim(), heading.id, { place }, /^(annotation|svg|script|style|tbody)$/);
    });
  const rows = () => [...document.querySelectorAll("main tbody > tr")].filter((row) => !row.closest(`${OUTSIDE}, .fold`))
    .map((row, number) => {
      row.id ||= `row-${number}`;
      const cells = [...row.cells].map((cell) => textOf(cell).trim()).filter(Boolean);
      const chapter = chapterOf(row);
      const place = chapter && textOf(chapter).trim();
      return entry([row], cells.slice(0, 2).join(": "), row.id, { place, isRow: true });
    });

  // A query as what all has to be there: words, of which several may mean the same, numbers, and numbers of equations.
  const terms = (query) => {
    let rest = plain(query).replace(/\s*([×·*])\s*10\s*\^?\s*/g, "$110^").trim();
    const found = [];
    for (const group of SAME) {
      const named = group.find((word) => (` ${rest} `).includes(` ${word} `));
      if (named) {
        found.push({ words: [named, ...group.filter((word) => word !== named)], said: named });
        rest = (` ${rest} `).replace(` ${named} `, " ").trim();
      }
    }
    for (const word of rest.split(" ").filter(Boolean)) {
      const [number] = [...word.matchAll(NUMBER)];
      const isNumber = number && number[0] === word;
      const reference = word.match(REFERENCE);
      found.push({
        words: [word], said: word,
        value: isNumber && (number[2] || number[3] || Number(word) < 1e-3) ? canonical(number[1], number[2] ?? number[3]) : undefined,
        reference: reference?.[1], isEquation: word.startsWith("(") && reference !== null,
      });
    }
    return found;
  };

  const isCited = ({ text, search: id }, { reference, isEquation }) => {
    const escaped = reference.replaceAll(".", "\\.");
    if (id === `eq-${reference}` || (!isEquation && new RegExp(`^(fig|tab|lst|section)-${escaped}$`).test(id))) return true;
    return new RegExp(`(?:\\(|equations? |eqs?\\. ${isEquation ? "" : "|figures? |figs?\\. |tables? |listings? |sections? |secs?\\. "})${escaped}(?![\\d.]*\\d)`).test(text);
  };
  const isThere = (one, term) => {
    if (term.reference && isCited(one, term)) return true;
    if (term.isEquation) return false;
    return term.words.some((word) => one.text.includes(word) || one.search.includes(word))
      || (term.value !== undefined && one.values.has(term.value));
  };

  // The better a place fits, the smaller its rank; a place that lacks something has none.
  const rank = (one, wanted) => {
    if (!wanted.every((term) => isThere(one, term))) return undefined;
    const phrase = wanted.map(({ said }) => said).join(" ");
    if (one.search === phrase || one.title.startsWith(`${phrase}:`)) return 0;
    const [{ reference, isEquation }] = wanted;
    if (wanted.length === 1 && reference) {
      if (one.search === `eq-${reference}`) return 0;
      if (!isEquation && one.card && one.search.endsWith(`-${reference}`)) return 1;
      if (one.elements.some((element) => [...element.querySelectorAll(".thesis-number")].some(({ textContent }) => textContent === `(${reference})`))) return 2;
    }
    const isSaid = (text) => wanted.every(({ words: [word] }) => text.includes(word));
    if (isSaid(one.title) || isSaid(one.search)) return 3;
    return (isSaid(one.text) ? 4 : 5) + (one.isRow ? 0.5 : 0);
  };

  // Ranges of the words in what was found; letters keep their places, so nothing is changed but their case.
  const rangesIn = (element, wanted) => {
    const ranges = [];
    const words = wanted.flatMap((term) => (term.isEquation ? [`(${term.reference})`] : term.words));
    const numbers = new Set(wanted.map(({ value }) => value).filter((value) => value !== undefined));
    const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT, ({ parentElement }) =>
      (parentElement.closest("annotation, svg, script") ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT));
    const add = (node, from, to) => {
      const range = new Range();
      range.setStart(node, from);
      range.setEnd(node, to);
      ranges.push(range);
    };
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const text = node.data.toLowerCase().replace(/[\u2212\u2010\u2011]/g, "-").replace(/\s/g, " ");
      for (const word of words) {
        for (let at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + word.length)) add(node, at, at + word.length);
      }
      if (numbers.size > 0) {
        for (const match of text.matchAll(NUMBER)) {
          if (numbers.has(canonical(match[1], match[2] ?? match[3]))) add(node, match.index, match.index + match[0].length);
        }
      }
    }
    for (const formula of numbers.size > 0 ? element.querySelectorAll("math") : []) {
      if ([...values(plain(textOf(formula)))].some((value) => numbers.has(value))) {
        const range = new Range();
        range.selectNodeContents(formula.querySelector("semantics > :first-child") ?? formula);
        ranges.push(range);
      }
    }
    return ranges;
  };
  const mark = (found, wanted) => {
    if (!globalThis.CSS?.highlights) return; // an older browser shows what was found without marks
    CSS.highlights.delete("search-hit");
    const ranges = found.slice(0, BY_HAND).flatMap(({ elements }) => elements.flatMap((element) => rangesIn(element, wanted)));
    if (ranges.length > 0) CSS.highlights.set("search-hit", new Highlight(...ranges));
  };

  let made; // when it is first needed: the text of the report is long
  return { entries: () => made ??= [...cards(), ...sections(), ...rows()], terms, rank, isThere, mark };
})();
