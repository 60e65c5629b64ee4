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
