//! A crate's public interface as Rust without bodies.

use syn::punctuated::Punctuated;
use syn::{Attribute, Fields, ImplItem, Item, TraitItem, Visibility, parse_quote};

use crate::crate_source::{Import, Source, imports, is_public_item, name};

/// All that can be named from outside, as text.
pub(crate) fn outline(source: &Source) -> String {
    prettyplease::unparse(&syn::File { shebang: None, attrs: vec![], items: module(source, &[]) })
}

/// The public items of a module in the order of their names, modules last.
fn module(source: &Source, path: &[String]) -> Vec<Item> {
    let mut named: Vec<(bool, String, Vec<Item>)> = Vec::new();
    for item in &source.modules[path].items {
        let own = name(item);
        match item {
            Item::Use(item) if is_hidden(&item.attrs) => {}
            Item::Mod(item) if is_hidden(&item.attrs) => {}
            Item::Use(item) if is_public_item(&item.vis) => {
                for import in imports(&item.tree) {
                    named.push((false, import.name.clone(), imported(source, path, &import, &item.attrs)));
                }
            }
            Item::Mod(item) if is_public_item(&item.vis) => {
                let inner = [path, &[item.ident.to_string()]].concat();
                let (ident, attrs) = (&item.ident, kept(&source.modules[&inner].attributes));
                let items = module(source, &inner);
                let shown = parse_quote! { #(#attrs)* pub mod #ident { #(#items)* } };
                named.push((true, item.ident.to_string(), vec![shown]));
            }
            // What a macro makes is not known; what it is given is.
            Item::Macro(item) if item.ident.is_none() => {
                let mut item = item.clone();
                item.mac.tokens = without_docs(item.mac.tokens);
                named.push((false, String::new(), vec![Item::Macro(item)]));
            }
            _ => {
                if let Some(own) = own {
                    named.push((false, own.clone(), defined(source, path, &own)));
                }
            }
        }
    }
    named.sort_by(|a, b| (a.0, &a.1).cmp(&(b.0, &b.1)));
    named.into_iter().flat_map(|(_, _, items)| items).collect()
}

/// Whether something is `#[doc(hidden)]`: public for other crates of the workspace alone, and nobody's to rely on.
fn is_hidden(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|own| {
        own.path().is_ident("doc") && own.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "hidden")
    })
}

/// What `pub use` shows: the item itself, unless it can be named where `use` takes it from or is another crate's.
fn imported(source: &Source, from: &[String], import: &Import, attributes: &[Attribute]) -> Vec<Item> {
    let within = match import.path.split_first() {
        Some((first, rest)) if first == "crate" => rest.to_vec(),
        _ => [from, &import.path[..]].concat(),
    };
    let named_there = within.split_last().is_some_and(|(_, within)| within != from && source.is_reachable(within));
    if !named_there
        && let Some((module, own)) = source.resolve(from, &import.path)
        && !source.is_reachable(&module)
        && !source.modules.contains_key(&[&module[..], std::slice::from_ref(&own)].concat())
    {
        return defined(source, &module, &own);
    }
    let tail = if import.path.last() == Some(&import.name) { String::new() } else { format!(" as {}", import.name) };
    let path = import.path.join("::");
    let tail = if path.ends_with('*') { String::new() } else { tail };
    let attributes = kept(attributes);
    let line: syn::ItemUse = syn::parse_str(&format!("pub use {path}{tail};")).expect("a path");
    vec![parse_quote! { #(#attributes)* #line }]
}

/// A public item of a module without its bodies, and what is implemented for it.
fn defined(source: &Source, module: &[String], own: &str) -> Vec<Item> {
    let Some(item) = source.modules[module].items.iter().find(|item| name(item).as_deref() == Some(own)) else {
        return vec![];
    };
    let Some(item) = bare(item) else { return vec![] };
    let implementations = source.implementations(module, own).into_iter().filter_map(bare_implementation);
    std::iter::once(item).chain(implementations.map(Item::Impl)).collect()
}

/// An item as others see it; `None` for what they do not.
fn bare(item: &Item) -> Option<Item> {
    let mut item = item.clone();
    let (visibility, attributes) = match &mut item {
        Item::Const(own) => {
            own.expr = parse_quote!(_);
            (&own.vis, &mut own.attrs)
        }
        Item::Enum(own) => {
            for variant in &mut own.variants {
                variant.attrs = kept(&variant.attrs);
                bare_fields(&mut variant.fields, false);
            }
            (&own.vis, &mut own.attrs)
        }
        Item::Fn(own) => {
            *own.block = parse_quote!({});
            (&own.vis, &mut own.attrs)
        }
        Item::Static(own) => {
            *own.expr = parse_quote!(_);
            (&own.vis, &mut own.attrs)
        }
        Item::Struct(own) => {
            bare_fields(&mut own.fields, true);
            (&own.vis, &mut own.attrs)
        }
        Item::Trait(own) => {
            own.items.iter_mut().for_each(bare_trait_item);
            (&own.vis, &mut own.attrs)
        }
        Item::Type(own) => (&own.vis, &mut own.attrs),
        _ => return None,
    };
    *attributes = kept(attributes);
    is_public_item(visibility).then_some(item)
}

/// Fields without their documentation; those of a struct that are private as one `private: _`.
fn bare_fields(fields: &mut Fields, of_struct: bool) {
    for field in fields.iter_mut() {
        field.attrs = kept(&field.attrs);
    }
    match fields {
        Fields::Named(named) if of_struct => {
            let all = named.named.len();
            let public = std::mem::take(&mut named.named).into_iter().filter(|field| is_public_item(&field.vis));
            named.named = Punctuated::from_iter(public);
            if named.named.len() < all {
                let private: syn::FieldsNamed = parse_quote!({ private: _ });
                named.named.extend(private.named);
            }
        }
        Fields::Unnamed(unnamed) if of_struct => {
            for field in unnamed.unnamed.iter_mut().filter(|field| !is_public_item(&field.vis)) {
                (field.vis, field.ty) = (Visibility::Inherited, parse_quote!(_));
            }
        }
        _ => {}
    }
}

/// A provided method keeps a body, an empty one.
fn bare_trait_item(item: &mut TraitItem) {
    match item {
        TraitItem::Fn(function) => {
            function.attrs = kept(&function.attrs);
            if let Some(body) = &mut function.default {
                *body = parse_quote!({});
            }
        }
        TraitItem::Const(item) => item.attrs = kept(&item.attrs),
        TraitItem::Type(item) => item.attrs = kept(&item.attrs),
        _ => {}
    }
}

/// Of a trait's implementation the head and its types; of another what is public, or `None` where that is nothing.
fn bare_implementation(item: &syn::ItemImpl) -> Option<syn::ItemImpl> {
    let mut item = item.clone();
    item.attrs = kept(&item.attrs);
    let of_trait = item.trait_.is_some();
    item.items.retain_mut(|item| match item {
        ImplItem::Fn(function) => {
            let shown = !of_trait && is_public_item(&function.vis) && !is_hidden(&function.attrs);
            function.attrs = kept(&function.attrs);
            function.block = parse_quote!({});
            shown
        }
        ImplItem::Const(item) => {
            (item.attrs, item.expr) = (kept(&item.attrs), parse_quote!(_));
            !of_trait && is_public_item(&item.vis)
        }
        ImplItem::Type(_) => of_trait,
        _ => false,
    });
    (of_trait || !item.items.is_empty()).then_some(item)
}

/// Attributes that others notice.
fn kept(attributes: &[Attribute]) -> Vec<Attribute> {
    let noticed = ["cfg", "derive", "non_exhaustive", "repr"];
    attributes.iter().filter(|own| noticed.iter().any(|name| own.path().is_ident(name))).cloned().collect()
}

/// Tokens without `#[doc = ...]`.
fn without_docs(tokens: proc_macro2::TokenStream) -> proc_macro2::TokenStream {
    let mut kept: Vec<proc_macro2::TokenTree> = Vec::new();
    for token in tokens {
        let is_doc =
            matches!(&token, proc_macro2::TokenTree::Group(group) if group.stream().to_string().starts_with("doc ="));
        if is_doc {
            kept.pop();
        } else {
            kept.push(token);
        }
    }
    kept.into_iter().collect()
}
