//! The source of a crate as a tree of modules, and what a name in it means.

use std::collections::BTreeMap;
use std::path::Path;

use syn::{Attribute, Item, ItemImpl, Type, UseTree, Visibility};

/// A path of modules below the crate's root.
pub(crate) type ModulePath = Vec<String>;

/// A module without its tests.
pub(crate) struct Module {
    pub(crate) items: Vec<Item>,
    pub(crate) is_public: bool,
    pub(crate) attributes: Vec<Attribute>,
}

/// A crate.
#[derive(Default)]
pub(crate) struct Source {
    pub(crate) modules: BTreeMap<ModulePath, Module>,
}

/// One name of a `use`: `use a::{b as c}` has the path `a, b` and the name `c`.
#[derive(Clone, Debug)]
pub(crate) struct Import {
    pub(crate) path: Vec<String>,
    pub(crate) name: String,
}

impl Source {
    /// Reads the file of a crate's root and those of its modules.
    pub(crate) fn read(root: &Path, read: &dyn Fn(&Path) -> Option<String>) -> Self {
        let mut source = Self::default();
        let text = read(root).unwrap_or_else(|| panic!("{}: cannot be read", root.display()));
        source.add(vec![], true, vec![], parse(root, &text), root.parent().expect("a folder"), read);
        source
    }

    fn add(
        &mut self,
        path: ModulePath,
        is_public: bool,
        attributes: Vec<Attribute>,
        items: Vec<Item>,
        folder: &Path,
        read: &dyn Fn(&Path) -> Option<String>,
    ) {
        let items: Vec<Item> = items.into_iter().filter(|item| !is_test(item)).collect();
        for item in &items {
            let Item::Mod(module) = item else { continue };
            let name = module.ident.to_string();
            let inner = match &module.content {
                Some((_, items)) => items.clone(),
                None => {
                    let files = [folder.join(format!("{name}.rs")), folder.join(&name).join("mod.rs")];
                    let found = files.iter().find_map(|file| Some(parse(file, &read(file)?)));
                    found.unwrap_or_else(|| panic!("{}: no file", files[0].display()))
                }
            };
            let path = [&path[..], std::slice::from_ref(&name)].concat();
            self.add(path, is_public_item(&module.vis), module.attrs.clone(), inner, &folder.join(&name), read);
        }
        self.modules.insert(path, Module { items, is_public, attributes });
    }

    /// Whether every module on the way to this one is public.
    pub(crate) fn is_reachable(&self, path: &[String]) -> bool {
        (1..=path.len()).all(|depth| self.modules.get(&path[..depth]).is_some_and(|module| module.is_public))
    }

    /// Where the item is defined that `path` names in the module `from`; `None` for those of other crates.
    pub(crate) fn resolve(&self, from: &[String], path: &[String]) -> Option<(ModulePath, String)> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => return self.resolve(&[], rest),
            "self" => return self.resolve(from, rest),
            "super" => return self.resolve(&from[..from.len().checked_sub(1)?], rest),
            _ => {}
        }
        let module = self.modules.get(from)?;
        let inner = [from, std::slice::from_ref(first)].concat();
        if !rest.is_empty() && self.modules.contains_key(&inner) {
            return self.resolve(&inner, rest);
        }
        if rest.is_empty() && module.items.iter().any(|item| name(item).as_ref() == Some(first)) {
            return Some((from.to_vec(), first.clone()));
        }
        let uses = module.items.iter().filter_map(|item| if let Item::Use(item) = item { Some(item) } else { None });
        let import = uses.flat_map(|item| imports(&item.tree)).find(|import| import.name == *first)?;
        // A crate's name, which stands for itself.
        if import.path.first() == Some(first) && import.path.len() == 1 {
            return None;
        }
        self.resolve(from, &[&import.path[..], rest].concat())
    }

    /// The implementations for the item `name` of the module `of`, wherever they are.
    pub(crate) fn implementations(&self, of: &[String], name: &str) -> Vec<&ItemImpl> {
        let mut found = Vec::new();
        for (path, module) in &self.modules {
            for item in &module.items {
                let Item::Impl(item) = item else { continue };
                let Type::Path(own) = &*item.self_ty else { continue };
                let segments: Vec<String> = own.path.segments.iter().map(|part| part.ident.to_string()).collect();
                if segments.last().is_some_and(|last| last == name)
                    && self.resolve(path, &segments).is_some_and(|(module, _)| module == of)
                {
                    found.push(item);
                }
            }
        }
        found
    }
}

fn parse(file: &Path, text: &str) -> Vec<Item> {
    syn::parse_file(text).unwrap_or_else(|error| panic!("{}: {error}", file.display())).items
}

pub(crate) fn is_public_item(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn is_test(item: &Item) -> bool {
    let (Item::Mod(syn::ItemMod { attrs, .. })
    | Item::Fn(syn::ItemFn { attrs, .. })
    | Item::Use(syn::ItemUse { attrs, .. })
    | Item::Impl(ItemImpl { attrs, .. })) = item
    else {
        return false;
    };
    attrs.iter().any(|attribute| {
        attribute.path().is_ident("cfg") && attribute.parse_args::<syn::Ident>().is_ok_and(|what| what == "test")
    })
}

/// The name under which an item can be found in its module, but for those that `use` brings.
pub(crate) fn name(item: &Item) -> Option<String> {
    Some(match item {
        Item::Const(item) => item.ident.to_string(),
        Item::Enum(item) => item.ident.to_string(),
        Item::Fn(item) => item.sig.ident.to_string(),
        Item::Mod(item) => item.ident.to_string(),
        Item::Static(item) => item.ident.to_string(),
        Item::Struct(item) => item.ident.to_string(),
        Item::Trait(item) => item.ident.to_string(),
        Item::Type(item) => item.ident.to_string(),
        _ => return None,
    })
}

/// All names of a `use`; one that ends in `*` has the name `*`.
pub(crate) fn imports(tree: &UseTree) -> Vec<Import> {
    let leaf = |last: String, name: String| vec![Import { path: vec![last], name }];
    match tree {
        UseTree::Name(last) => leaf(last.ident.to_string(), last.ident.to_string()),
        UseTree::Rename(last) => leaf(last.ident.to_string(), last.rename.to_string()),
        UseTree::Glob(_) => leaf("*".to_owned(), "*".to_owned()),
        UseTree::Group(group) => group.items.iter().flat_map(imports).collect(),
        UseTree::Path(path) => {
            let first = path.ident.to_string();
            let within = imports(&path.tree).into_iter();
            within.map(|import| below(&first, import)).collect()
        }
    }
}

/// `use first::{import}`; `use first::{self}` names `first`.
fn below(first: &str, import: Import) -> Import {
    if import.path == ["self"] {
        let name = if import.name == "self" { first.to_owned() } else { import.name };
        return Import { path: vec![first.to_owned()], name };
    }
    Import { path: [&[first.to_owned()], &import.path[..]].concat(), name: import.name }
}
