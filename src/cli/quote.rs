//! `houscaper quote`: the quote of one house as a page, a table and JSON.

use anyhow::anyhow;
use houscaper::export::tables::bom_csv;
use houscaper::price::{QuoteHead, bill, quote, quote_html};
use houscaper::run::RunFolder;
use houscaper::score::{SizingGoal, floor_area_m2};
use houscaper::structure::Verdict;
use jiff::civil::Date;
use jiff::{Timestamp, tz::TimeZone};
use serde_json::json;

use super::args::Quote;
use super::failure::{Blame, Failure, Outcome};
use super::input;
use super::output::{check_folder, say};

pub fn run(args: Quote, json: bool) -> Outcome {
    check_folder(&args.out)?;
    let evaluator = input::evaluator_for(args.brief.as_deref(), args.prices.as_deref())?;
    let house = input::house(&args.voxels, &args.import)?;
    let choices = match &args.choices {
        Some(flag) => super::choices::from_flag(flag, &evaluator)?,
        None => evaluator.size(&house, SizingGoal::from(args.size)).map(|s| s.choices()).unwrap_or_default(),
    };
    let details = evaluator.details(&house, &choices);
    let Some(takeoff) = &details.evaluation.takeoff else {
        return Err(Failure::Input(anyhow!(
            "{}: no skin can be measured, so nothing can be priced; `houscaper check` names the cells",
            args.voxels.display()
        )));
    };
    let section = |number: u16| evaluator.catalogue.section_id(number);
    let name = input::name_of(&args.voxels);
    let issued = day(args.date.as_deref())?;
    let head = QuoteHead { name: name.clone(), floor_area_m2: floor_area_m2(&details.reading), issued: Some(issued) };
    let quote = quote(&head, takeoff, &evaluator.books, &section).run()?;
    let lines = bill(takeoff, &evaluator.books, &section).run()?;
    let mark = json!({"schema": "houscaper.quote-run/1", "name": name});
    let folder = RunFolder::create(&args.out, mark.to_string().as_bytes()).input()?;
    let text = serde_json::to_string_pretty(&quote).run()?;
    folder.write("quote.json", text.as_bytes()).run()?;
    folder.write("quote.html", quote_html(&quote).as_bytes()).run()?;
    folder.write("bom.csv", bom_csv(&lines).as_bytes()).run()?;
    if details.evaluation.assessment.as_ref().is_none_or(|a| a.verdict != Verdict::Ok) {
        eprintln!(
            "note: the frame of this house is not ok, so that its price is of no house that stands; `houscaper build` says why"
        );
    }
    if json {
        say!("{text}");
        return Ok(());
    }
    say!("quote {} of {}, valid until {}", quote.reference, quote.issued, quote.valid_until);
    let [low, price, high] = quote.price_eur;
    say!("envelope and frame in place, net of VAT: {price:.2} {} ({low:.0} to {high:.0})", quote.currency);
    say!(
        "with design and VAT: {:.2} {} ({:.0} to {:.0})",
        quote.total[1],
        quote.currency,
        quote.total[0],
        quote.total[2]
    );
    say!("quote.html, quote.json and bom.csv in {}", args.out.display());
    Ok(())
}

/// The day of issue: as asked for, else today.
fn day(asked: Option<&str>) -> Result<Date, Failure> {
    let Some(text) = asked else {
        return Ok(Timestamp::now().to_zoned(TimeZone::UTC).date());
    };
    text.parse()
        .map_err(|_| Failure::Input(anyhow!("--date {text}: expected a day of the calendar, such as 2027-01-31")))
}
