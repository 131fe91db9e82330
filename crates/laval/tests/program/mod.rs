//! What the program says and shows: mistakes, texts, figures, documents, the structure of the code.

mod add_a_part;
mod all_mistakes;
mod architecture;
mod bench_clock;
mod catalogues;
mod constructed;
mod diagnostic_codes;
mod docs;
mod figures;
mod findings;
mod interrupts;
mod labels;
mod pages;
mod said_of_the_file;
mod stopped;
mod templates;
mod terms;
mod texts;
mod theory;
mod threads;
mod typical_mistakes;
mod validation;
