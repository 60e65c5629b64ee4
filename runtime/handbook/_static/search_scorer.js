/* Search: results whose title has more words of the query come first, and how-to guides before lists. */
var Scorer = {
  score: ([page, title, , , score]) => {
    const query = new URLSearchParams(location.search).get("q") || document.activeElement.value || "";
    const stems = query.toLowerCase().split(/\W+/).filter((word) => word.length > 2).map((word) => word.slice(0, 5));
    const found = stems.filter((stem) => title.toLowerCase().includes(stem.replace(/s$/, "")));
    return score + 8 * found.length + (page.startsWith("howto/") ? 3 : 0);
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};

/* Every word counts, so a page without one of them is found too, behind those that have more. */
const withAll = Search.performTermsSearch;
Search.performTermsSearch = (words, excluded) => {
  const found = new Map();
  for (const word of words) {
    for (const result of withAll(new Set([word]), excluded)) {
      const before = found.get(result[0]);
      if (before) before[4] += result[4];
      else found.set(result[0], result);
    }
  }
  return [...found.values()].sort((a, b) => b[4] - a[4]).slice(0, 20);
};
