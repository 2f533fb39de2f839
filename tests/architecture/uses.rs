//! Which file of a crate uses which, read from its sources: imports (grouped, renamed, of everything), paths in code and
//! in macros' arguments. A name that a module re-exports counts as a use of the file that defines it.
//!
//! Code for tests is left out. Calls of methods name no path, so they are not seen.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Ident, Item, UseTree};

/// One use of a file by another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Use {
    pub(crate) from: String,
    pub(crate) line: usize,
    /// As written, without braces.
    pub(crate) path: String,
    pub(crate) to: String,
}

/// The modules of a crate, its root first, by file.
pub(crate) struct Modules {
    modules: Vec<Module>,
}

#[derive(Default)]
struct Module {
    file: String,
    parent: Option<usize>,
    children: BTreeMap<String, usize>,
    /// Items that are written here.
    items: BTreeSet<String>,
    /// Names that imports bring, with the path of each.
    imports: Vec<(String, Vec<String>)>,
    /// Paths of which everything is imported.
    globs: Vec<Vec<String>>,
    /// Every path written in the module, with its line.
    paths: Vec<(Vec<String>, usize)>,
}

impl Modules {
    /// From the texts of a crate's files by their paths below `src`, with `/`; `root` is `lib.rs` or `main.rs`.
    ///
    /// # Panics
    /// For a file that is not there or not Rust.
    pub(crate) fn read(files: &BTreeMap<String, String>, root: &str) -> Self {
        let mut read = Self { modules: Vec::new() };
        let root = read.add(root, None);
        read.read_file(files, root, "");
        read
    }

    /// From these files and their texts, for tests of the checks.
    pub(crate) fn made_up(files: &[(&str, &str)]) -> Self {
        let files = files.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned()));
        Self::read(&files.collect(), "lib.rs")
    }

    fn add(&mut self, file: &str, parent: Option<usize>) -> usize {
        self.modules.push(Module { file: file.to_owned(), parent, ..Module::default() });
        self.modules.len() - 1
    }

    /// Reads a module that is a file; its children lie in `folder`, which is empty or ends in `/`.
    fn read_file(&mut self, files: &BTreeMap<String, String>, module: usize, folder: &str) {
        let file = self.modules[module].file.clone();
        let parsed = syn::parse_file(&files[&file]).unwrap_or_else(|error| panic!("{file}: {error}"));
        self.read_items(files, module, folder, &parsed.items);
    }

    fn read_items(&mut self, files: &BTreeMap<String, String>, module: usize, folder: &str, items: &[Item]) {
        let mut found = Found::default();
        for item in items {
            let Item::Mod(child) = item else {
                found.visit_item(item);
                continue;
            };
            if for_tests(&child.attrs) {
                continue;
            }
            let name = child.ident.to_string();
            let below = format!("{folder}{name}/");
            let own =
                [format!("{folder}{name}.rs"), format!("{below}mod.rs")].into_iter().find(|f| files.contains_key(f));
            let file = match &child.content {
                Some(_) => self.modules[module].file.clone(),
                None => own.unwrap_or_else(|| panic!("{}: no file for `mod {name};`", self.modules[module].file)),
            };
            let index = self.add(&file, Some(module));
            self.modules[module].children.insert(name, index);
            match &child.content {
                Some((_, items)) => self.read_items(files, index, &below, items),
                None => self.read_file(files, index, &below),
            }
        }
        let own = &mut self.modules[module];
        own.items = items.iter().filter_map(name_of).map(ToString::to_string).collect();
        (own.imports, own.globs, own.paths) = (found.imports, found.globs, found.paths);
    }

    /// Every use of one file by another, sorted. To name a module is no use of its file; to name what is in it is.
    pub(crate) fn uses(&self) -> BTreeSet<Use> {
        let mut uses = BTreeSet::new();
        for (index, module) in self.modules.iter().enumerate() {
            for (path, line) in &module.paths {
                // A single name may be that of a variable, unless everything of another module is imported.
                let files = match path.as_slice() {
                    [_] if module.items.contains(&path[0]) => continue,
                    [_] => self.files_by_globs(index, path, &mut Vec::new()),
                    _ => self.files_of(index, path, &mut Vec::new()),
                };
                for to in files.into_iter().filter(|to| *to != module.file) {
                    let (from, path) = (module.file.clone(), path.join("::"));
                    uses.insert(Use { from, line: *line, path, to: to.to_owned() });
                }
            }
        }
        uses
    }

    /// The file of the module around that of each file.
    pub(crate) fn parents(&self) -> BTreeMap<&str, &str> {
        let pairs = self.modules.iter().filter_map(|m| Some((m.file.as_str(), self.modules[m.parent?].file.as_str())));
        pairs.filter(|(file, parent)| file != parent).collect()
    }

    /// Files that define what a path in `module` names; none for a module itself and for what other crates define.
    fn files_of<'m>(&'m self, module: usize, path: &[String], followed: &mut Followed<'m>) -> BTreeSet<&'m str> {
        let (mut at, mut rest) = (module, path);
        while let [first, after @ ..] = rest {
            at = match first.as_str() {
                "crate" => 0,
                "self" => at,
                "super" => self.modules[at].parent.unwrap_or(0),
                _ => break,
            };
            rest = after;
        }
        let files = self.files_below(at, rest, followed);
        // `crate::x` of which no `x` is seen: a macro has made it.
        let is_made = files.is_empty() && rest.len() < path.len() && self.module_of(at, rest).is_none();
        if is_made { BTreeSet::from([self.modules[at].file.as_str()]) } else { files }
    }

    /// The same for a path that begins with a name in `module`.
    fn files_below<'m>(&'m self, module: usize, path: &[String], followed: &mut Followed<'m>) -> BTreeSet<&'m str> {
        let own = &self.modules[module];
        let [name, rest @ ..] = path else { return BTreeSet::new() };
        let mut files = BTreeSet::new();
        let mut is_here = own.items.contains(name);
        if is_here {
            files.insert(own.file.as_str());
        }
        if let Some(child) = own.children.get(name) {
            is_here = true;
            let below = self.files_below(*child, rest, followed);
            let is_made = below.is_empty() && self.module_of(*child, rest).is_none();
            files.extend(if is_made { BTreeSet::from([self.modules[*child].file.as_str()]) } else { below });
        }
        for (_, import) in own.imports.iter().filter(|(known, _)| known == name) {
            is_here = true;
            if !followed.contains(&(module, import)) {
                followed.push((module, import));
                files.extend(self.files_of(module, &[import, rest].concat(), followed));
                followed.pop();
            }
        }
        if is_here { files } else { self.files_by_globs(module, path, followed) }
    }

    /// The same for a name that `module` has only if one of its imports of everything brings it.
    fn files_by_globs<'m>(&'m self, module: usize, path: &[String], followed: &mut Followed<'m>) -> BTreeSet<&'m str> {
        let mut files = BTreeSet::new();
        for glob in &self.modules[module].globs {
            let Some(from) = self.module_of(module, glob) else { continue };
            if !followed.contains(&(module, glob)) {
                followed.push((module, glob));
                files.extend(self.files_below(from, path, followed));
                followed.pop();
            }
        }
        files
    }

    /// The module that a path names without the help of imports.
    fn module_of(&self, module: usize, path: &[String]) -> Option<usize> {
        path.iter().try_fold(module, |at, name| match name.as_str() {
            "crate" => Some(0),
            "self" => Some(at),
            "super" => self.modules[at].parent,
            name => self.modules[at].children.get(name).copied(),
        })
    }
}

/// Imports that have led to where a path is being looked for, with their modules: they may lead to each other.
type Followed<'m> = Vec<(usize, &'m Vec<String>)>;

/// What a module's items mention.
#[derive(Default)]
struct Found {
    imports: Vec<(String, Vec<String>)>,
    globs: Vec<Vec<String>>,
    paths: Vec<(Vec<String>, usize)>,
}

impl Found {
    fn import(&mut self, tree: &UseTree, before: &[String]) {
        let with = |ident: &Ident| [before, &[ident.to_string()]].concat();
        match tree {
            UseTree::Path(path) => self.import(&path.tree, &with(&path.ident)),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.import(tree, before)),
            UseTree::Glob(glob) => {
                self.paths.push(([before, &["*".to_owned()]].concat(), line(glob.star_token.spans[0])));
                self.globs.push(before.to_vec());
            }
            UseTree::Name(name) => self.bind(&name.ident, &name.ident, before),
            UseTree::Rename(rename) => self.bind(&rename.ident, &rename.rename, before),
        }
    }

    /// `use before::ident as name`.
    fn bind(&mut self, ident: &Ident, name: &Ident, before: &[String]) {
        // `use a::{self}` brings the name `a`.
        let (path, name) = match before.last() {
            Some(last) if ident == "self" => {
                (before.to_vec(), if name == "self" { last.clone() } else { name.to_string() })
            }
            _ => ([before, &[ident.to_string()]].concat(), name.to_string()),
        };
        self.paths.push((path.clone(), line(ident.span())));
        self.imports.push((name, path));
    }

    /// Paths of at least two names in the arguments or the body of a macro.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut path: Vec<Ident> = Vec::new();
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Ident(ident) => {
                    if colons != 2 {
                        self.end_of(&mut path);
                    }
                    path.push(ident);
                    colons = 0;
                    continue;
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' && colons < 2 => {
                    colons += 1;
                    continue;
                }
                TokenTree::Group(group) => self.tokens(group.stream()),
                _ => {}
            }
            self.end_of(&mut path);
            colons = 0;
        }
        self.end_of(&mut path);
    }

    fn end_of(&mut self, path: &mut Vec<Ident>) {
        if let [first, _, ..] = path.as_slice() {
            self.paths.push((path.iter().map(ToString::to_string).collect(), line(first.span())));
        }
        path.clear();
    }
}

/// Visits what is not for tests alone.
macro_rules! but_for_tests {
    ($($visit:ident $item:ident),*) => {
        $(fn $visit(&mut self, item: &'ast syn::$item) {
            if !for_tests(&item.attrs) {
                visit::$visit(self, item);
            }
        })*
    };
}

impl<'ast> Visit<'ast> for Found {
    but_for_tests!(
        visit_item_const ItemConst, visit_item_fn ItemFn, visit_item_impl ItemImpl, visit_item_mod ItemMod,
        visit_item_static ItemStatic, visit_item_struct ItemStruct, visit_impl_item_fn ImplItemFn
    );

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        // `use ::a` is of another crate.
        if !for_tests(&item.attrs) && item.leading_colon.is_none() {
            self.import(&item.tree, &[]);
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if path.leading_colon.is_none() {
            self.paths.push((names, line(path.segments[0].ident.span())));
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        self.tokens(called.tokens.clone());
        visit::visit_macro(self, called);
    }

    /// `pub(in crate::x)` uses nothing.
    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}

    fn visit_attribute(&mut self, _: &'ast Attribute) {}
}

fn line(span: Span) -> usize {
    span.start().line
}

/// Whether `#[cfg(test)]` stands above.
fn for_tests(attributes: &[Attribute]) -> bool {
    let condition = |a: &Attribute| a.meta.require_list().map(|list| list.tokens.to_string()).unwrap_or_default();
    attributes.iter().filter(|a| a.path().is_ident("cfg")).any(|a| {
        let condition = condition(a);
        condition == "test" || condition.starts_with("all (test ,")
    })
}

/// The name that an item gives to its module, but for modules and imports.
fn name_of(item: &Item) -> Option<&Ident> {
    match item {
        Item::Const(item) => Some(&item.ident),
        Item::Enum(item) => Some(&item.ident),
        Item::Fn(item) => Some(&item.sig.ident),
        Item::Macro(item) => item.ident.as_ref(),
        Item::Static(item) => Some(&item.ident),
        Item::Struct(item) => Some(&item.ident),
        Item::Trait(item) => Some(&item.ident),
        Item::Type(item) => Some(&item.ident),
        _ => None,
    }
}
