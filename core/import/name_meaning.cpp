// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/name_meaning.h"

#include "core/import/cells.h"
#include "core/import/name_derivatives.h"
#include "core/import/name_forms.h"
#include "core/import/name_reading.h"
#include "core/import/spellings.h"

#include <algorithm>
#include <tuple>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;
using Kind = NameMeaning::Kind;
using Doubt = NameMeaning::Doubt;

/// Greek letters that denote other angles than the coupler's, such as the transmission angle.
constexpr std::string_view kOtherAngles = "gamma delta lambda";

/// Returns the channel whose name has the same letters and digits, regardless of punctuation.
std::optional<Channel> channelSpelled(const Words &words, int derivatives)
{
    std::string text;
    for (const std::string &word : words) {
        text += word;
    }
    for (std::size_t index = 0; index < kCoordinateCount; ++index) {
        const Channel channel = channelAt(index);
        std::string name = lowered(nameOf(channel));
        std::erase(name, '_');
        if (name == text && derivatives <= static_cast<int>(Order::Acceleration)) {
            return Channel{channel.coordinate, static_cast<Order>(derivatives)};
        }
    }
    return std::nullopt;
}

/// Returns whether the name is α in a unit of angles: then it is an angle and no angular acceleration.
bool isAngleAlpha(const NameReading &name, const std::optional<Unit> &unit)
{
    const bool isAlpha = findWord(name.symbol, WordUse::Symbol) && name.order == Order::Acceleration &&
                         name.dimension == Dimension::Angle;
    return isAlpha && name.derivatives == 0 && unit && unit->dimension == Dimension::Angle && unit->order == 0;
}

/// Returns how many times the quantity is differentiated with respect to the time; nullopt if neither the name nor its
/// unit states this. The words of the name and its marks of derivatives have priority over the unit.
std::optional<int> derivativesOf(const NameReading &name, const std::optional<Unit> &unit)
{
    if (isAngleAlpha(name, unit)) {
        return 0;
    }
    if (name.order) {
        const int named = static_cast<int>(*name.order);
        const bool isSaidTwice = name.isOrderNamed && name.hasSymbol && named == name.derivatives; // "velocity ẋ"
        return isSaidTwice ? named : named + name.derivatives;
    }
    if (unit && (name.derivatives == 0 || name.unknown.exist())) { // "dλ/dt (mm/s)"
        return unit->order;
    }
    const bool isPositionOrDerivative = name.hasSymbol || name.derivatives > 0 || name.body;
    return isPositionOrDerivative ? std::optional(name.derivatives) : std::nullopt;
}

/// Returns the coordinate that the name denotes: θ1 for the frame, θ2 for the crank, and θ3 for any other angle; x or y
/// of the named body, x if no axis is named. A length without a body is assigned to the slider. unnamed_bodies.h
/// corrects these assignments by the values.
Coordinate coordinateOf(const NameReading &name, bool isAngle)
{
    if (isAngle) {
        const Coordinate ofLink = name.body == Body::Crank ? Theta2 : Theta3;
        return name.isFrame ? Theta1 : ofLink;
    }
    const bool isY = name.axis == 'y';
    switch (name.body.value_or(Body::Slider)) {
    case Body::Crank: return isY ? R2y : R2x;
    case Body::Coupler: return isY ? R3y : R3x;
    case Body::Slider: break;
    }
    return isY ? R4y : R4x;
}

/// Returns whether the name or its unit denotes an angle. If neither does, a coordinate of the coupler is one.
bool isOfAngle(const NameReading &name, const std::optional<Unit> &unit, const NamePath &path)
{
    const bool isAlone = !name.namesQuantity() && !name.derivatives;        // "coupler"
    const bool isCoordinate = isAlone || path.isInSi || name.symbol == "q"; // "/joint_states/rod/position", "q_rod"
    const bool isOfCoupler = name.body == Body::Coupler && isCoordinate;
    const Dimension withoutUnit = isOfCoupler ? Dimension::Angle : Dimension::Length;
    return name.dimension.value_or(unit ? unit->dimension : withoutUnit) == Dimension::Angle;
}

/// Returns whether name and unit determine a quantity. With a unit (not of time), any known or unknown word is enough.
/// Without a unit, the name has to state an order, symbol or axis, or, if all its words are known, at least a body. In
/// a path with unknown words, a dimension or body is needed as well: "MyModel.jnt.Pos" may be an angle or a length.
bool determinesQuantity(const NameReading &name, const std::optional<Unit> &unit, bool isPath)
{
    if (unit) {
        return unit->dimension != Dimension::Time &&
               (name.namesQuantity() || name.body || name.dimension || name.unknown.exist());
    }
    if (name.unknown.exist()) {
        return name.namesQuantity() && (!isPath || name.dimension || name.body);
    }
    return name.namesQuantity() || name.body;
}

/// Returns the question about a name that only the other columns can decide. The first that applies:
///
/// 1. a generalized coordinate q with a unit: None (it belongs to the crank only if it turns),
/// 2. `isOfUnknown`, an unknown point or body such as the A of "x_A": IsAngleOfUnknown or IsOfPoint,
/// 3. a length of a numbered part: IsOfPart,
/// 4. α without a unit, a body and marks of derivatives: IsAngle,
/// 5. without a unit, the doubt that the words left; with a unit, None.
NameMeaning::Doubt findDoubt(const NameReading &name, const std::optional<Unit> &unit, bool isAngle, bool isOfUnknown)
{
    if (name.symbol == "q" && unit) {
        return Doubt::None;
    }
    if (isOfUnknown) {
        return isAngle ? Doubt::IsAngleOfUnknown : Doubt::IsOfPoint;
    }
    if (!name.unknown.point.empty() && !name.body && !isAngle) {
        return Doubt::IsOfPart;
    }
    if (isAmong(name.symbol, "alpha alfa al") && !name.body && !unit && !name.derivatives) {
        return Doubt::IsAngle;
    }
    return unit ? Doubt::None : name.doubt;
}

/// Returns whether the name is a symbol that cannot have the unit, such as W in m/s², an acceleration in Russian, and A
/// in degrees, the crank angle in the English Wikipedia.
bool isForeignSymbol(const NameReading &name, const std::optional<Unit> &unit)
{
    if (!unit || name.symbol.empty() || name.axis != ' ' || name.body || unit->dimension == Dimension::Time) {
        return false;
    }
    const bool isOpenRate = !name.dimension && name.order && unit->order == 0; // v and a, of lengths or angles
    return isOpenRate ? unit->dimension == Dimension::Angle : name.dimension && unit->dimension != *name.dimension;
}

/// Returns whether a name has an index or words for a point or body that is not crank, coupler or slider: "x_G", "phase
/// angle". But "λ (mm)" has no index, and "angle of bar BC" names the ends of its link.
bool isOfUnknownPoint(const NameReading &name, bool isAngle)
{
    const bool isIndexOfSymbol = (name.namesQuantity() || isAngle) && name.unknown.areIndices() && !name.body;
    const bool isUnknownAngle =
        isAngle && name.dimension && name.unknown.hasWord && !name.body && name.pointLetters.empty();
    return name.isUnknownBody || isIndexOfSymbol || isUnknownAngle;
}

/// Returns whether a name consists of words for a body and its quantity, so that it needs no guess.
bool namesBodyAndQuantity(const NameReading &name, const std::optional<Unit> &unit, bool isAngle)
{
    const bool namesQuantity = name.namesQuantity() || unit || (isAngle && name.dimension);
    return namesQuantity && name.isBodyNamed && (name.body || name.isFrame);
}

/// Returns the name of the point or body that a column describes: columns with the same owner describe the same one.
std::string ownerOf(const NameReading &name, const NamePath &path)
{
    if (name.unknown.exist() && !name.body) {
        return name.unknown.point.empty() ? name.unknown.text : name.unknown.point;
    }
    return path.owner + name.pointLetters;
}

/// Returns whether the quantity of a name can be a channel: the slider has no angle, and the crank and the coupler have
/// no lengths except those of their centres of mass.
bool mayBeChannel(const NameReading &name, bool isAngle)
{
    if (!name.body) {
        return true;
    }
    if (*name.body == Body::Slider) {
        return !isAngle;
    }
    return isAngle || (name.isCentre && name.axis != ' ');
}

/// Returns why a name whose quantity is unknown, or can be no channel, has no meaning.
ColumnReason reasonWithoutChannel(const NameReading &name, const std::optional<Unit> &unit)
{
    if (name.unknown.exist() && name.order && !unit && !name.body) {
        return ColumnReason::UnknownBody;
    }
    const bool isOfCrankPin = name.body == Body::Crank && name.axis != ' ';
    return isOfCrankPin ? ColumnReason::CrankPin : ColumnReason::UnknownName;
}

/// Returns the channel or quantity of a name whose words have been read. If no word is known, the unit decides.
NameMeaning meaningOfReading(const NameReading &name, const NamePath &path, const std::string &unitText)
{
    const std::optional<Unit> unit = parseUnit(unitText);
    if (isForeignSymbol(name, unit)) {
        const NameReading unknown{.derivatives = name.derivatives, .unknown = {.text = name.symbol}};
        return meaningOfReading(unknown, path, unitText);
    }
    const bool isAngle = isOfAngle(name, unit, path);
    if (isAngle && isAmong(name.unknown.text, kOtherAngles)) {
        return {};
    }
    const std::optional<int> derivatives =
        determinesQuantity(name, unit, path.parts.size() > 2) ? derivativesOf(name, unit) : std::nullopt;
    if (!derivatives || *derivatives > static_cast<int>(Order::Acceleration) || !mayBeChannel(name, isAngle)) {
        return {.reason = reasonWithoutChannel(name, unit)};
    }
    const auto order = static_cast<Order>(*derivatives);
    const bool isOfUnknown = isOfUnknownPoint(name, isAngle);
    const bool isKnownBody = namesBodyAndQuantity(name, unit, isAngle);
    const bool isCoordinateOfAnyKind = name.symbol == "q" && !unit && !name.isBodyNamed; // an angle or a length
    NameMeaning meaning{.kind = isKnownBody && !isOfUnknown ? Kind::Words : Kind::Quantity,
                        .channel = {coordinateOf(name, isAngle), order},
                        .reason = isKnownBody ? ColumnReason::KnownName : ColumnReason::QuantityInName,
                        .owner = ownerOf(name, path),
                        .symbol = name.symbol,
                        .doubt = findDoubt(name, unit, isAngle, isOfUnknown),
                        .hasUnknownWords = name.unknown.exist() || isOfUnknown || isCoordinateOfAnyKind,
                        .namesAxis = name.axis != ' ',
                        .isNumberedLink = name.isBodyNumbered,
                        .isFirstLink = name.link == "1",
                        .isAtB = name.isAtB && order == Order::Position};
    if (path.isInSi && unitText.empty()) {
        meaning.reason = ColumnReason::PathInSi;
    } else if (meaning.hasUnknownWords) {
        meaning.reason = ColumnReason::UnknownWords;
    }
    return meaning;
}

/// Returns the meaning of P[3.1], V[3.1] and A[3.1] in Inventor's Output Grapher, where only the unit
/// distinguishes an angle from a length.
std::optional<NameMeaning> meaningInInventor(std::string_view name, const std::string &unitText)
{
    constexpr std::string_view kLetters = "PVA";
    const std::size_t end = name.find(']'); // the joint may follow: "P[1] (Prismatic:4)"
    const bool isLast = end + 1 == name.size() || name.substr(end + 1).starts_with(" (");
    const std::size_t order = name.size() >= 4 && name[1] == '[' && isLast ? kLetters.find(name[0]) : kLetters.npos;
    if (order == kLetters.npos) {
        return std::nullopt;
    }
    const std::optional<Unit> unit = parseUnit(unitText);
    if (!unit) {
        return NameMeaning{.reason = unitText.empty() ? ColumnReason::AngleOrLength : ColumnReason::UnknownUnit};
    }
    const Coordinate coordinate = unit->dimension == Dimension::Angle ? Theta3 : R4x;
    return NameMeaning{Kind::Quantity,
                       {coordinate, static_cast<Order>(order)},
                       ColumnReason::QuantityInName,
                       std::string(name.substr(2, end - 2))};
}

/// Returns whether a word names the z axis, as in "z", "vz" and "pz".
bool namesZ(const std::string &word)
{
    return word == "z" || (word.size() == 2 && word[1] == 'z' && findWord(word.substr(0, 1), WordUse::Symbol));
}

/// Returns whether a name begins with the letter of a point before its quantity: "A vx", "B x", "C velocity". A is a
/// point only where it is no acceleration: before a velocity, a length such as "A x (mm)", and a derivative
/// ("A_x_diff").
bool beginsWithPoint(const Words &words, int derivatives, const std::optional<Unit> &unit)
{
    if (words.size() < 2 || !isAmong(words[0], "a b c")) {
        return false;
    }
    const std::string &quantity = words[1];
    if (words[0] == "a") {
        const bool isLength = unit && unit->dimension == Dimension::Length && unit->order == 0;
        return isAmong(quantity, "vx vy") || ((isLength || derivatives > 0) && isAmong(quantity, "x y"));
    }
    const WordMeaning *const word = findWord(quantity, WordUse::Word);
    const bool hasAxis = quantity.size() == 2 && isAmong(quantity.substr(1), "x y");
    const bool isSymbol = findWord(quantity.substr(0, 1), WordUse::Symbol) && (quantity.size() == 1 || hasAxis);
    return isSymbol || (word && word->order && !word->body);
}

/// Puts the letter of a point at the beginning of a name behind the quantity: "x B" for "B x" and "Bx". But "by hand"
/// has no point.
void putPointBehindQuantity(Words &words, std::string_view name, int derivatives, const std::optional<Unit> &unit)
{
    const bool isWord = words.size() > 1 || !name.starts_with('B');
    if (words.empty() || (isWord && words[0] == "by")) {
        return;
    }
    if (isAmong(words[0].substr(0, 1), "b c") && isAmong(words[0].substr(1), "x y vx vy ax ay")) {
        words.insert(words.begin() + 1, words[0].substr(1));
        words[0].resize(1);
    }
    if (beginsWithPoint(words, derivatives, unit)) {
        std::swap(words[0], words[1]);
    }
}

/// Returns the meaning of the name of a time or of a row number; nullopt if it is neither.
std::optional<NameMeaning> meaningOfTimeOrNumber(const Words &words, std::string_view lastPart, const std::string &unit)
{
    constexpr std::string_view kCountedUnits = "steps step frames frame samples sample rows points pasos muestras";
    if (!isTime(words)) {
        const bool isNumber = lastPart == "#" || (namesRowNumber(words) && !parseUnit(unit));
        return isNumber ? std::optional(NameMeaning{.reason = ColumnReason::RowNumber}) : std::nullopt;
    }
    if (isAmong(unit, kCountedUnits)) {
        return NameMeaning{.reason = ColumnReason::RowNumber};
    }
    const bool isTorque = lastPart == "T" && !unit.empty() && !parseColumnUnit(unit, ColumnRole::Time, {});
    return isTorque ? NameMeaning{.reason = ColumnReason::UnknownUnit} : NameMeaning{Kind::Time};
}

/// Returns the name before a remark in brackets that says that finite differences were computed: "v" of
/// "v (num. diff.)". Returns an empty text for other names: "x (diff)" is itself a derivative.
std::string_view nameBeforeDifferences(std::string_view name)
{
    const std::size_t bracket = name.rfind('(');
    const Words remark = bracket == name.npos ? Words() : wordsOf(name.substr(bracket));
    if (!name.ends_with(')') || !namesDifferences(remark)) {
        return {};
    }
    const std::string_view before = trimmed(name.substr(0, bracket));
    const auto differentiates = [](const std::string &word) { return isAmong(word, "diff dif"); };
    const bool isOfPosition = meaningOf(before, {}).channel.order == Order::Position;
    return isOfPosition && std::ranges::any_of(remark, differentiates) ? std::string_view() : before;
}

/// Returns the name of the derivative that finite differences approximate: "dx/dt" for "Δx/Δt", "diff(x, t)" for
/// "np.gradient(x, t)", "v" for "v (num. diff.)". Returns nullopt for other names.
std::optional<std::string> derivativeOfDifferences(std::string_view name)
{
    if (const std::string_view before = nameBeforeDifferences(name); !before.empty()) {
        return std::string(before);
    }
    static const Spellings kDerivatives{{"\\Delta ", "d"}, {"\\Delta\\", "d"},        {"\\Delta", "d"},      {"Δ", "d"},
                                        {"∆", "d"},        {"np.gradient(", "diff("}, {"gradient(", "diff("}};
    std::string derivative = kDerivatives.replacedIn(name);
    const bool isCall = derivative.starts_with("diff(");
    const bool isQuotient = derivative.starts_with('d') && derivative.find("/d") != derivative.npos;
    return derivative != name && (isCall || isQuotient) ? std::optional(std::move(derivative)) : std::nullopt;
}

/// Returns the meaning of a name of several words, which are read together.
NameMeaning meaningOfWords(std::string_view name, const NamePath &path, int derivatives, const Words &words,
                           const std::string &unit)
{
    std::optional<NameReading> reading = readName(path, derivatives, words);
    const bool isAboutZ = std::ranges::any_of(wordsOf(name), namesZ); // the motion is in x and y, and z is only an axis
    if (!reading || (isAboutZ && reading->dimension != Dimension::Angle)) {
        return {};
    }
    if (isAboutZ && !reading->body && unit.empty()) { // "Z_AngVel", of any body
        reading->isUnknownBody = true;
    }
    if (isElement(name)) {
        reading->isUnknownBody = reading->axis == ' '; // "X(3)" is the x of a node
        reading->unknown.point = name.substr(name.rfind('('));
    }
    return meaningOfReading(*reading, path, unit);
}

/// Returns the meaning of a name that may be a path, such as "slider.s", differentiated `derivatives` times.
NameMeaning meaningOfPath(std::string_view name, int derivatives, const std::string &unit)
{
    static const Spellings kPathSpellings{{"/dt", "dt"},  {"/Dt", "dt"}, {"/DT", "dt"}, {"/ dt", "dt"},
                                          {"/d t", "dt"}, {"₊", "."}}; // the first are no paths, the last is Julia's
    const std::string plain = kPathSpellings.replacedIn(name);
    const NamePath path = splitPath(plain);
    if (path.parts.empty()) {
        return {};
    }
    const std::string_view lastPart = path.parts.back();
    Words words = path.isOfModelica ? Words{'.' + std::string(lastPart)} : wordsOf(lastPart);
    if (const std::optional<NameMeaning> meaning = meaningOfTimeOrNumber(words, lastPart, unit)) {
        return *meaning;
    }
    derivatives += takeDerivatives(words);
    const bool isAngularAcceleration =
        !unit.empty() && parseColumnUnit(unit, ColumnRole::Channel, {Theta3, Order::Acceleration});
    if (isAngularAcceleration && !words.empty() && words.front() == "a") { // "a3 (rad/s²)"
        words.front() = "alpha";
    }
    if (const std::optional<Channel> channel = channelSpelled(words, derivatives)) {
        return {Kind::ChannelName, *channel, ColumnReason::KnownName};
    }
    if (words.size() == 3 && isAmong(words[0], "omega w") && words[1] == "2" && words[2] == "t") { // "ω₂t (deg)"
        words.erase(words.begin() + 1);
    }
    putPointBehindQuantity(words, lastPart, derivatives, parseUnit(unit));
    return meaningOfWords(name, path, derivatives, words, unit);
}

} // namespace

NameMeaning meaningOf(std::string_view name, const std::string &unit)
{
    if (name.size() > kMaxNameSize || isMagnitude(name) || isRelative(name)) {
        return {};
    }
    if (isRatio(name)) {
        return {.reason = ColumnReason::Ratio};
    }
    if (const std::optional<std::string> derivative = derivativeOfDifferences(name)) {
        NameMeaning meaning = meaningOf(*derivative, unit);
        if (meaning.kind >= Kind::Quantity) { // a column of the derivative itself is better evidence
            meaning.kind = Kind::Quantity;
            meaning.reason = ColumnReason::UnknownWords;
            meaning.hasUnknownWords = true;
        }
        return meaning;
    }
    if (isOverAngle(name, unit)) {
        return {.reason = ColumnReason::OverAngle};
    }
    if (const std::size_t equals = name.find(" = "); name.find_first_of("+*/(", equals) != name.npos) {
        const NameMeaning meaning = meaningOf(name.substr(0, equals), unit); // "v = dx/dt", "φ = asin(λ sin θ)"
        if (meaning.kind != Kind::Time) { // "time = np.linspace(0, 1)" is a line of a program
            return meaning;
        }
    }
    if (const std::optional<NameMeaning> meaning = meaningInInventor(name, unit)) {
        return *meaning;
    }
    const int derivatives = takeDerivativeCalls(name, parseUnit(unit));
    return meaningOfPath(withoutTrailingRemark(name), derivatives, unit);
}

std::weak_ordering compareEvidence(const NameMeaning &first, const NameMeaning &second)
{
    const auto evidenceOf = [](const NameMeaning &meaning) {
        return std::tuple(meaning.kind, !meaning.hasUnknownWords, !meaning.isAtB, meaning.namesAxis);
    };
    return evidenceOf(first) <=> evidenceOf(second);
}

} // namespace slidercrank
