//! The built page. It is committed, so that nothing but Rust is needed to build the program.

/// Address below the token, kind and content.
pub(crate) const FILES: [(&str, &str, &str); 4] = [
    ("", "text/html; charset=utf-8", include_str!("../assets/index.html")),
    ("assets/studio.css", "text/css; charset=utf-8", include_str!("../assets/studio.css")),
    ("assets/studio.js", "text/javascript; charset=utf-8", include_str!("../assets/studio.js")),
    ("assets/scene.js", "text/javascript; charset=utf-8", include_str!("../assets/scene.js")),
];
