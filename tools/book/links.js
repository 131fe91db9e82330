// Pages link to files of the repository that the book does not hold, such as sources: there the link becomes text with the path.
(function () {
    const root = new URL(path_to_root === "" ? "./" : path_to_root, document.location.href).pathname;
    for (const link of document.querySelectorAll("main a[href]")) {
        const url = new URL(link.getAttribute("href"), document.location.href);
        const local = url.protocol === document.location.protocol && url.host === document.location.host;
        if (!local || url.pathname.startsWith(root)) {
            continue;
        }
        const text = document.createElement("span");
        text.append(...link.childNodes);
        text.className = "of-the-repository";
        text.title = "In the repository: " + link.getAttribute("href").replace(/^(\.\.\/)+/, "").replace(/\.html(#.*)?$/, ".md");
        link.replaceWith(text);
    }
})();
