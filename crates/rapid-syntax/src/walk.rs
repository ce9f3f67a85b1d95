//! Every node of a tree in source order: for checks over the whole tree, and for tools that look at text.

use super::tree::{
    Arg, ArgKind, Callee, DataDecl, Expr, ExprKind, FileItem, HandlerKind, Module, ModuleItem, Param,
    Routine, RoutineKind, Stmt, StmtKind, Tree,
};
use crate::diagnostic::TextRange;

/// One node, seen without its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Node {
    /// From its first byte to its last.
    pub range: TextRange,
    /// How many nodes hold it.
    pub depth: u32,
    /// What it is, in one word.
    pub what: &'static str,
}

/// All nodes, each before those it holds, in source order.
#[must_use]
pub fn nodes(tree: &Tree) -> Vec<Node> {
    let mut collector = NodeCollector { depth: 0, nodes: Vec::new() };
    if let Some(header) = tree.header {
        collector.leaf(header, "header");
    }
    for item in &tree.items {
        match item {
            FileItem::Module(m) => collector.module(m),
            FileItem::Comment(r) => collector.leaf(*r, "comment"),
            FileItem::Opaque(r) => collector.leaf(*r, "opaque"),
        }
    }
    collector.nodes
}

/// The nodes that hold no others, in source order: they do not overlap, and between them stand white
/// space, comments inside statements, punctuation and reserved words.
#[must_use]
pub fn leaves(tree: &Tree) -> Vec<Node> {
    let nodes = nodes(tree);
    let holds = |i: usize| nodes.get(i + 1).is_some_and(|next| next.depth > nodes[i].depth);
    (0..nodes.len()).filter(|&i| !holds(i)).map(|i| nodes[i]).collect()
}

struct NodeCollector {
    depth: u32,
    nodes: Vec<Node>,
}

impl NodeCollector {
    fn leaf(&mut self, range: TextRange, what: &'static str) {
        self.nodes.push(Node { range, depth: self.depth, what });
    }

    fn node(&mut self, range: TextRange, what: &'static str, inside: impl FnOnce(&mut Self)) {
        self.leaf(range, what);
        self.depth += 1;
        inside(self);
        self.depth -= 1;
    }

    fn module(&mut self, m: &Module) {
        self.node(m.range, "module", |w| {
            w.node(m.head, "head", |w| {
                w.leaf(m.name, "name");
                m.attributes.iter().for_each(|a| w.leaf(*a, "name"));
            });
            for item in &m.items {
                match item {
                    ModuleItem::Data(d) => w.data(d),
                    ModuleItem::Record(r) => w.node(r.range, "record", |w| {
                        w.leaf(r.name, "name");
                        for (type_name, name) in &r.components {
                            w.leaf(*type_name, "name");
                            w.leaf(*name, "name");
                        }
                    }),
                    ModuleItem::Alias(a) => w.node(a.range, "alias", |w| {
                        w.leaf(a.type_name, "name");
                        w.leaf(a.name, "name");
                    }),
                    ModuleItem::Routine(r) => w.routine(r),
                    ModuleItem::Comment(r) => w.leaf(*r, "comment"),
                    ModuleItem::Opaque(r) => w.leaf(*r, "opaque"),
                }
            }
            m.end.iter().for_each(|e| w.leaf(*e, "end"));
        });
    }

    fn data(&mut self, d: &DataDecl) {
        self.node(d.range, "data", |w| {
            w.leaf(d.type_name, "name");
            w.leaf(d.name, "name");
            d.dims.iter().for_each(|e| w.expr(e));
            d.init.iter().for_each(|e| w.expr(e));
        });
    }

    fn routine(&mut self, r: &Routine) {
        self.node(r.range, "routine", |w| {
            w.node(r.head, "head", |w| {
                if let RoutineKind::Func(value) = r.kind {
                    w.leaf(value, "name");
                }
                w.leaf(r.name, "name");
                r.params.iter().for_each(|p| w.param(p));
            });
            w.stmts(&r.body);
            for h in &r.handlers {
                w.node(h.range, "handler", |w| {
                    if let HandlerKind::Error(numbers) = &h.kind {
                        numbers.iter().for_each(|e| w.expr(e));
                    }
                    w.stmts(&h.body);
                });
            }
            r.end.iter().for_each(|e| w.leaf(*e, "end"));
        });
    }

    fn param(&mut self, p: &Param) {
        if p.range == p.name {
            return self.leaf(p.range, "placeholder");
        }
        self.node(p.range, "parameter", |w| {
            w.leaf(p.type_name, "name");
            w.leaf(p.name, "name");
        });
    }

    fn stmts(&mut self, stmts: &[Stmt]) {
        stmts.iter().for_each(|s| self.stmt(s));
    }

    fn stmt(&mut self, s: &Stmt) {
        match &s.kind {
            StmtKind::Data(d) => self.data(d),
            StmtKind::Assign(assign) => self.node(s.range, "assignment", |w| {
                w.expr(&assign.target);
                w.expr(&assign.value);
            }),
            StmtKind::Call(call) => self.node(s.range, "call", |w| {
                match &call.callee {
                    Callee::Name(name) => w.leaf(*name, "name"),
                    Callee::Late(expr) => w.expr(expr),
                }
                call.args.iter().for_each(|a| w.arg(a));
            }),
            StmtKind::If(branch) => self.node(s.range, "if", |w| {
                for (cond, body) in &branch.arms {
                    w.expr(cond);
                    w.stmts(body);
                }
                branch.otherwise.iter().for_each(|body| w.stmts(body));
            }),
            StmtKind::CompactIf(branch) => self.node(s.range, "if", |w| {
                w.expr(&branch.cond);
                w.stmt(&branch.then);
            }),
            StmtKind::For(l) => self.node(s.range, "for", |w| {
                w.leaf(l.var, "name");
                [&l.from, &l.to].into_iter().chain(&l.step).for_each(|e| w.expr(e));
                w.stmts(&l.body);
            }),
            StmtKind::While(l) => self.node(s.range, "while", |w| {
                w.expr(&l.cond);
                w.stmts(&l.body);
            }),
            StmtKind::Test(test) => self.node(s.range, "test", |w| {
                w.expr(&test.value);
                for (values, body) in &test.cases {
                    values.iter().for_each(|e| w.expr(e));
                    w.stmts(body);
                }
                test.default.iter().for_each(|body| w.stmts(body));
            }),
            StmtKind::Label(name) => self.node(s.range, "label", |w| w.leaf(*name, "name")),
            StmtKind::Goto(name) => self.node(s.range, "goto", |w| w.leaf(*name, "name")),
            StmtKind::Return(value) => self.node(s.range, "return", |w| value.iter().for_each(|e| w.expr(e))),
            StmtKind::Raise(value) => self.node(s.range, "raise", |w| value.iter().for_each(|e| w.expr(e))),
            StmtKind::Connect(connect) => self.node(s.range, "connect", |w| {
                w.expr(&connect.interrupt);
                w.leaf(connect.trap, "name");
            }),
            StmtKind::Retry => self.leaf(s.range, "retry"),
            StmtKind::TryNext => self.leaf(s.range, "trynext"),
            StmtKind::Exit => self.leaf(s.range, "exit"),
            StmtKind::Empty => self.leaf(s.range, "empty"),
            StmtKind::Placeholder => self.leaf(s.range, "placeholder"),
            StmtKind::Comment => self.leaf(s.range, "comment"),
            StmtKind::Opaque => self.leaf(s.range, "opaque"),
        }
    }

    fn arg(&mut self, a: &Arg) {
        match &a.kind {
            ArgKind::Positional(e) if a.range.start < e.range.start => self.node(a.range, "argument", |w| {
                w.leaf(TextRange::new(a.range.start, e.range.start), "parameter");
                w.expr(e);
            }),
            ArgKind::Positional(e) => self.expr(e),
            ArgKind::Named { name, value } => self.node(a.range, "option", |w| {
                w.leaf(*name, "name");
                value.iter().for_each(|e| w.expr(e));
            }),
            ArgKind::Conditional { name, param } => self.node(a.range, "option", |w| {
                w.leaf(*name, "name");
                w.leaf(*param, "name");
            }),
        }
    }

    fn exprs(&mut self, exprs: &[Expr]) {
        exprs.iter().for_each(|e| self.expr(e));
    }

    fn expr(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::Number => self.leaf(e.range, "number"),
            ExprKind::Numbers => self.leaf(e.range, "numbers"),
            ExprKind::String => self.leaf(e.range, "string"),
            ExprKind::Bool(_) => self.leaf(e.range, "bool"),
            ExprKind::Name => self.leaf(e.range, "name"),
            ExprKind::Placeholder => self.leaf(e.range, "placeholder"),
            ExprKind::Opaque => self.leaf(e.range, "opaque"),
            ExprKind::Field(field) => self.node(e.range, "component", |w| {
                w.expr(&field.base);
                w.leaf(field.name, "name");
            }),
            ExprKind::Index(element) => self.node(e.range, "element", |w| {
                w.expr(&element.base);
                w.exprs(&element.indices);
            }),
            ExprKind::Aggregate(parts) => self.node(e.range, "aggregate", |w| w.exprs(parts)),
            ExprKind::Call(call) => self.node(e.range, "call", |w| {
                w.leaf(call.name, "name");
                call.args.iter().for_each(|a| w.arg(a));
            }),
            ExprKind::Unary { operand, .. } => self.node(e.range, "unary", |w| w.expr(operand)),
            ExprKind::Binary(binary) => self.node(e.range, "binary", |w| {
                w.expr(&binary.lhs);
                w.expr(&binary.rhs);
            }),
            ExprKind::Paren(inner) => self.node(e.range, "parentheses", |w| w.expr(inner)),
        }
    }
}
