//! Just enough SVG for diagrams: panels with axes, dots, vectors, text. Knows nothing of what is drawn.

use std::fmt::Write;

/// A picture in the making.
pub struct Picture {
    text: String,
}

/// A diagram's place in the picture (pixels) and what its axes span.
#[derive(Clone, Copy, Debug)]
pub struct Panel {
    /// Left edge of the drawing area.
    pub left: f64,
    /// Upper edge of the drawing area.
    pub top: f64,
    /// Width of the drawing area.
    pub width: f64,
    /// Height of the drawing area.
    pub height: f64,
    /// Horizontal axis, low to high.
    pub x: [f64; 2],
    /// Vertical axis, low to high.
    pub y: [f64; 2],
}

impl Panel {
    /// Where a value stands, pixels.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let share = |v: f64, [low, high]: [f64; 2]| (v - low) / (high - low).max(1e-12);
        [
            self.left + share(x, self.x).clamp(0.0, 1.0) * self.width,
            self.top + (1.0 - share(y, self.y).clamp(0.0, 1.0)) * self.height,
        ]
    }
}

impl Picture {
    /// A white picture with a title.
    #[must_use]
    pub fn new(width: f64, height: f64, title: &str) -> Self {
        let mut picture = Self { text: String::new() };
        picture.add(format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" font-family=\"sans-serif\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>"
        ));
        picture.text(20.0, 30.0, 18.0, "start", title);
        picture
    }

    fn add(&mut self, what: std::fmt::Arguments<'_>) {
        let _ = writeln!(self.text, "{what}"); // writing to a String cannot fail
    }

    /// A line of text; `anchor` is start, middle or end.
    pub fn text(&mut self, x: f64, y: f64, size: f64, anchor: &str, text: &str) {
        let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        self.add(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"#222\">{text}</text>"
        ));
    }

    /// Draws a filled circle.
    pub fn dot(&mut self, x: f64, y: f64, radius: f64, colour: &str) {
        self.add(format_args!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{colour}\" fill-opacity=\"0.55\"/>"
        ));
    }

    /// A vector with a dot at its foot.
    pub fn vector(&mut self, from: [f64; 2], to: [f64; 2], colour: &str) {
        self.add(format_args!(
            "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" stroke=\"{colour}\" stroke-width=\"1.2\" fill=\"none\"/>",
            from[0], from[1], to[0], to[1]
        ));
        self.dot(from[0], from[1], 1.4, colour);
    }

    /// Frame, ticks and names of a panel's axes.
    pub fn axes(&mut self, panel: &Panel, x_name: &str, y_name: &str) {
        let Panel { left, top, width, height, .. } = *panel;
        self.add(format_args!(
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"none\" stroke=\"#888\"/>"
        ));
        let (values, decimals) = ticks(panel.x);
        for value in values {
            let [x, _] = panel.at(value, panel.y[0]);
            self.grid([x, top], [x, top + height]);
            self.text(x, top + height + 15.0, 11.0, "middle", &format!("{value:.decimals$}"));
        }
        let (values, decimals) = ticks(panel.y);
        for value in values {
            let [_, y] = panel.at(panel.x[0], value);
            self.grid([left, y], [left + width, y]);
            self.text(left - 5.0, y + 4.0, 11.0, "end", &format!("{value:.decimals$}"));
        }
        self.text(left + width / 2.0, top + height + 32.0, 12.0, "middle", x_name);
        self.text(left, top - 6.0, 12.0, "start", y_name);
    }

    fn grid(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.add(format_args!(
            "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" stroke=\"#e4e4e4\"/>",
            from[0], from[1], to[0], to[1]
        ));
    }

    /// The picture as SVG text.
    #[must_use]
    pub fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }
}

/// Four to nine round values within a range, and the decimals that they need.
fn ticks([low, high]: [f64; 2]) -> (Vec<f64>, usize) {
    let rough = (high - low).max(1e-9) / 5.0;
    let ten = 10.0_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|f| f * ten).into_iter().find(|s| *s >= rough).unwrap_or(ten);
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    let decimals = (-step.log10().floor()).max(0.0) as usize;
    ((first..=last).map(|k| k as f64 * step).collect(), decimals)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(ticks([0.0, 1.0]), (vec![0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0], 1));
        assert_eq!(ticks([-95.0, 95.0]).0, [-50.0, 0.0, 50.0]);
        assert_eq!(ticks([0.0, 0.043]).1, 2);
    }

    #[test]
    fn low_values_stand_low_and_left() {
        let panel = Panel { left: 10.0, top: 20.0, width: 100.0, height: 50.0, x: [0.0, 2.0], y: [0.0, 4.0] };
        assert_eq!(panel.at(0.0, 0.0), [10.0, 70.0]);
        assert_eq!(panel.at(1.0, 4.0), [60.0, 20.0]);
    }
}
