// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/vocabulary.h"

#include "core/import/cells.h"
#include "core/import/spellings.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;

/// Letters outside ASCII, and the plain spelling of all letters of a row. Accents that are separate characters (U+0300
/// …) are behind their letter.
constexpr auto kLetters = std::to_array<Spelling>({{"áàăåâãäą", "a"},
                                                   {"čçć", "c"},
                                                   {"ď", "d"},
                                                   {"ěëéèêę", "e"},
                                                   {"ğ", "g"},
                                                   {"ıîïíì", "i"},
                                                   {"ľł", "l"},
                                                   {"ňñ", "n"},
                                                   {"őøóòôõö", "o"},
                                                   {"ř", "r"},
                                                   {"šşșś", "s"},
                                                   {"ťţț", "t"},
                                                   {"űůûúùü", "u"},
                                                   {"ý", "y"},
                                                   {"žż", "z"},
                                                   {"ÁÀÂÄÃÅ", "A"},
                                                   {"ÇČĆ", "C"},
                                                   {"ÉÈÊ", "E"},
                                                   {"İÍ", "I"},
                                                   {"Ł", "L"},
                                                   {"Ñ", "N"},
                                                   {"ÓÖÔØ", "O"},
                                                   {"Ř", "R"},
                                                   {"ŠŚŞ", "S"},
                                                   {"ÚÜ", "U"},
                                                   {"ŽŻ", "Z"},
                                                   {"ẋẊ", "x' "},
                                                   {"ẍẌ", "x'' "},
                                                   {"ẏẎ", "y' "},
                                                   {"ÿ", "y'' "},
                                                   {"ṡṠ", "s' "},
                                                   {"ḋḊ", "d' "},
                                                   {"ṙṘ", "r' "},
                                                   {"′’´", "'"},
                                                   {"θϑΘ", "theta"},
                                                   {"φϕΦ", "phi"},
                                                   {"ψΨ", "psi"},
                                                   {"ωΩ", "omega"},
                                                   {"α", "alpha"},
                                                   {"β", "beta"},
                                                   {"εϵ", "epsilon"},
                                                   {"₁", "1"},
                                                   {"²₂", "2"},
                                                   {"³₃", "3"},
                                                   {"⁴₄", "4"},
                                                   {"ₓ", "x"},
                                                   {"ᵦ", "b"},
                                                   {"°", ""},
                                                   {"\u0300\u0301\u0303", ""}});

/// The plain spellings of letters, of groups of characters, and of commands of LaTeX; small letters for the capital
/// ones of Cyrillic.
const Spellings kLetterSpellings = [] {
    Spellings table{{"ß", "ss"},       {"æ", "ae"},      {"″", "''"},      {"a\u0308", "a"}, {"o\u0308", "o"},
                    {"u\u0308", "u"},  {"A\u0308", "A"}, {"O\u0308", "O"}, {"U\u0308", "U"}, {"\u0307", "' "},
                    {"\u0308", "'' "}, {"ˍtt", "'' "},   {"ˍt", "' "},     {"n°", ""},       {"nº", ""},
                    {"aTDC", "atdc"},  {"der(", "dot "}, {"\\var", ""},    {"\\,", ""}};
    for (const Spelling &letters : kLetters) {
        table.addCharacters(letters.from, letters.to);
    }
    table.addPairs("ЁАБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯё", "еабвгдежзийклмнопрстуфхцчшщъыьэюяе");
    return table;
}();

/// The words of a kind of short names: at least one of `words`, and beside these only `companions` and numbers.
struct ShortNames {
    std::string_view words;
    std::string_view companions{};
};

constexpr ShortNames kTimes{
    "time times t ts tiempo timestamp stamp zeit zeitpunkt temps tempo instante tijd denbora 시간 "
    "czas tid cas timp zaman sure epoch millis micros время 时间 時間 時刻 ido aika",
    "elapsed row sim simulation simulacion transcurrido de la since start date relative run "
    "latest data set ch mechanism kin current reference ref cycle"};
constexpr ShortNames kClockWords{"uhrzeit clock hora heure ora godzina"};
constexpr ShortNames kMethods{"num anal exp sim calc theo teo ber gem mess med fem mbs abs"};
constexpr ShortNames kDifferences{"diff dif fd differences differenzen diferencias differenze",
                                  "finite central forward backward num numeric numerical numerisch finitas centradas "
                                  "finies"};
constexpr ShortNames kStatistics{
    "mean average avg media medio promedio mittelwert durchschnitt moyenne moyen gemiddelde srednia max maximum maximo "
    "massimo maksimum min minimum minimo minimal minimaal sum suma summe somme soma rms median mediana std stdev",
    "value valor valeur valore wert waarde of de"};
constexpr ShortNames kRowNumbers{"n i no nr num index row id fila frame slice image imagen bild scan paso step sample "
                                 "count counter point node nodo element elemento",
                                 "data of de der measurement messung messpunkt medicion medida mesure misura medicao "
                                 "pomiar"};

constexpr std::string_view kTurnsPerMinute = "rpm drehzahl regime giri revoluciones toerental obroty";
constexpr std::string_view kTurnsPerSecond = "rps drehfrequenz crank_frequency rotation_frequency";

/// The vocabulary, in the languages of core/README.md. Words with a dot are variables of Modelica and Simscape.
namespace vocabulary
{
using enum WordUse;
using enum Dimension;
using enum Order;
using enum Body;
constexpr std::nullopt_t kOpen = std::nullopt;
constexpr auto kRows = std::to_array<WordMeaning>(
    {// Quantities.
     {Word,
      "position positions posicion posizione posizioni posicao posicoes posicio positie polozenie lage pos "
      "displacement disp posn "
      "displ desloc degistirme despl depl spost versch lvdt encoder transducer "
      "transductor potentiometer wegaufnehmer laser pot poti sonar ultrasonic dist location "
      "ubicacion avance avanzamento avanco ascissa abscissa abscisa yol yolu reading lectura "
      "lecture lettura leitura stellung ablesung desplazamiento deplacement spostamento "
      "deslocamento desplacament verplaatsing przemieszczenie verschiebung weg auslenkung abscisse "
      "pose konum pozitie poloha draha droga motion movimiento "
      "mouvement movimento bewegung beweging 변위 위치 deplasare posisjon forskyvning "
      "helyzet elmozdulas paikka asema qpos положение перемещение 位置 位移 変位",
      kOpen, Position},
     {Word,
      "coordinate coordenada coordonnee distance distancia distanza abstand strok glissement "
      "longueur longitud lunghezza comprimento translation traslacion traslazione translacao stroke "
      "carrera course corsa curso cursa hub travel recorrido slag skok zdvih lopmozgas length hub_h "
      "координата ход",
      Length, Position},
     {Word,
      "velocity velocidad velocita velocidade velocitat vitesse speed vel geschwindigkeit geschw "
      "veloc snelheid predkosc rapidez hastighet hastighed rychlost viteza hiz hizi rate twist "
      "velocities predk snelh qvel sebesseg nopeus 속도 скорость 速度",
      kOpen, Velocity},
     {Word,
      "acceleration aceler acceler przysp versn aceleracion accelerazione aceleracao acceleracio "
      "accelerometer accel acel acc beschleunigung beschl versnelling przyspieszenie zrychleni "
      "acceleratie ivme ivmesi acceleratia akselerasjon gyorsulas kiihtyvyys qacc 가속도 "
      "ускорение 加速度",
      kOpen, Acceleration},
     {Word,
      "angle ang angulo angolo rotation rot rotacion rotazione rotacao giro orientation winkel hoek kat "
      "vinkel uhel unghi drehwinkel aci acisi inclination inclinacion neigung revolutions revolution szog "
      "kulma uhol 각도 угол 角度 转角",
      Angle, Position},
     {Word,
      "angular angulaire angolare rotational rotary hoeksnelheid revolute rz katowa katowe "
      "katowy uhlova uhlove unghiulara угловая угловое угловой 角",
      Angle},
     {Word, "gyroscope gyro giroscopio gyroskop", Angle, Velocity},
     {Word,
      "linear lineal lineaire lineare translational trans prismatic prismatico prismatica "
      "prismatique prismatisch schub",
      Length},
     {Word, "horizontal horizontale tx", Length, kOpen, kOpen, 'x'},
     {Word, "vertical verticale ty", Length, kOpen, kOpen, 'y'},
     {Word, kTurnsPerMinute, Angle, Velocity, Crank},
     {Word, kTurnsPerSecond, Angle, Velocity, Crank},
     // Bodies. A wheel with a pin is a crank.
     {Word,
      "crank crankpin motor moteur motore shaft welle eccentric excentrica exzenter input entrada entree antrieb "
      "crankshaft wheel flywheel disk disc driver manivela maneta manivelle manovella ciguenal "
      "vilebrequin virabrequim volante rueda kurbel kurbelwelle schwungrad kruk krukas korba korby "
      "vev vevaxel klika kliky krank veiv krumtap forgattyu kampi kammen krumtapaksel veivaksel "
      "kluky klukoveho big_end kurbelzapfen maneton munon moente 크랭크 кривошип 曲柄 曲轴 クランク link_2 glied_2 "
      "eslabon_2 barra_2 bar_2 membro_2",
      kOpen, kOpen, Crank},
     {Word, "ca cad kw owk kurbelw atdc omega_t w_t", Angle, Position, Crank},
     {Word,
      "coupler coup rod conrod connecting biela bielle biella bielei acoplador pleuel pleuelstange koppel "
      "schubstange drijfstang koppelstang plejlstang rade radens korbowod lacznik "
      "vevstake ojnice biyel hajtorud hajtokar 커넥팅로드 kiertokanki kiertokangen шатун "
      "連接棒 连杆 コンロッド link_3 glied_3 eslabon_3 barra_3 bar_3",
      kOpen, kOpen, Coupler},
     {Word,
      "slider slide kizak kizagi stantuffo cart piston pistone pistao pisto corredera deslizadera "
      "deslizador deslizante corredora corredissa embolo carro carrito cursore cursor pattino "
      "coulisseau coulissant surgu abtrieb glissiere crosshead block bloque kolben output salida sortie "
      "schieber gleitstein schlitten kreuzkopf zuiger schuif suwak wodzik крейцкопф uscita saida "
      "tlok tloka kolv kolven sliden glid gliden piestu smykadla patina "
      "culisei 슬라이더 피스톤 pist pistu wrist gudgeon ram plunger corsoio corredica pistonului stempel "
      "stemplets dugattyu manta mannan luisti ariete stossel small_end bulon spinotto kolbenbolzen piede_di_biella "
      "pied_de_bielle pie_de_biela ползун поршень поршня 滑块 活塞 "
      "スライダ スライダー ピストン link_4 glied_4 eslabon_4 barra_4 bar_4",
      kOpen, kOpen, Slider},
     {Word, "schwenkwinkel obliquity", Angle, Position, Coupler},
     // Symbols of textbooks. The order of x and θ is that of the unit, or that of a position.
     {Symbol, "x", Length, kOpen, kOpen, 'x'},
     {Symbol, "y", Length, kOpen, kOpen, 'y'},
     {Symbol, "s d r", Length},
     {Symbol, "q"}, // a generalized coordinate
     {Symbol, "v", kOpen, Velocity},
     {Symbol, "a", kOpen, Acceleration},
     {Symbol, "theta th teta tita phi fi psi psiz beta", Angle},
     {Symbol, "omega om w", Angle, Velocity},
     {Symbol, "alpha alfa al epsilon", Angle, Acceleration},
     {Symbol, "px", Length, Position, kOpen, 'x'},
     {Symbol, "py", Length, Position, kOpen, 'y'},
     {Symbol, "r_1 r_0", Length, Position}, // the vector of the frame in a vector loop, to the slider
     {Filler, "o_2 o_4"},                   // the crank pivot of "distance O2B"
     {Word, "l_4", Length, Position, Slider},
     // Variables of Modelica and Simscape.
     {Symbol, ".s .p", Length, Position},
     {Symbol, ".v", Length, Velocity},
     {Symbol, ".a", kOpen, Acceleration},
     {Symbol, ".phi .q", Angle, Position},
     {Symbol, ".w .w[3] .w_a[3]", Angle, Velocity},
     {Symbol, ".z[3] .z_a[3]", Angle, Acceleration},
     {Symbol, ".r_0[1] .r[1] .s[1]", Length, Position, kOpen, 'x'},
     {Symbol, ".r_0[2] .r[2]", Length, Position, kOpen, 'y'},
     {Symbol, ".v_0[1] .v[1]", Length, Velocity, kOpen, 'x'},
     {Symbol, ".a_0[1] .a[1]", Length, Acceleration, kOpen, 'x'},
     // Indices: the wrist pin is called B or C, or P, K and S after the piston, Kolben and slider; A is the crank pin.
     {Index, "b c k s", kOpen, kOpen, Slider},
     {Index, "a"},
     {Index, "oa ob oc ao bo co", kOpen, kOpen, Crank},
     {Index, "ab ba ac ca ap pa bc cb bd db bp pb cd dc cp pc"},
     // Centres of mass.
     {.words = "g_2", .body = Crank, .isCentre = true},
     {Word, "rx_3", Length, Position, Coupler, 'x', true},
     {Word, "ry_3", Length, Position, Coupler, 'y', true},
     {.words = "g_3", .body = Coupler, .isCentre = true},
     {.words = "g_4", .body = Slider, .isCentre = true},
     {.use = Filler, .words = "centre center centroid midpoint cg cog cm com", .isCentre = true},
     // Derivatives.
     {Derivative,
      "' dot diff prime punto punkt ponto punt kropka derivative derivada deriv ableitung "
      "first_derivative st_derivative st_deriv dt",
      kOpen, Velocity},
     {Derivative,
      "ddot diff_2 ddiff double_dot double_prime dos_puntos 2_puntos dois_pontos 2_punkt "
      "zwei_punkt zweipunkt 2_punten doble_punto point_point deux_points second_derivative "
      "nd_derivative nd_deriv segunda_derivada zweite_ableitung dd pp dt_2",
      kOpen, Acceleration},
     {AmbiguousLetter, "d p point", kOpen, Velocity},
     {Filler, "de del la el da do du di des della delle dello der die das of the van het en au a_la in con "
              "component comp field out act actual instantaneous relative measured medido gemessen mesuree misurato "
              "misurata z open crossed o pin obrotu "
              "поворота повороту"},
     {OtherQuantity,
      "error err erreur errore erro fehler fel fout blad chyba hata ошибка 误差 deviation desviacion "
      "abweichung scarto ecart desvio odchylka uncertainty incertidumbre incertitude incertezza "
      "unsicherheit std stdev sd sigma variance residual tolerance difference desired target setpoint cmd "
      "current corriente courant corrente strom "
      "ref reference soll sollwert consigna consigne force fuerza forza forca kraft kracht sila kuvvet "
      "сила 力 torque par couple coppia moment momento drehmoment pressure presion pression "
      "pressione pressao druck cisnienie power energy work transmission transmision trasmissione "
      "transmissao ubertragungswinkel przeniesienia ratio jerk cam camshaft nocken valve ventil valvula "
      "soupape follower spring feder resorte muelle ressort molla mola belt riemen correa gap spalt "
      "sin cos tan phase pitch roll yaw azimuth heading latitude normal tangential coriolis wear verschleiss "
      "drift backlash holgura level count limit tilt cycle ciclo zyklus percent percentage pct porcentaje "
      "prozent pourcentage percentuale fraction segment segmento strecke radius radio rayon raggio diameter "
      "durchmesser diametro diametre clearance frequency frecuencia frequencia frequenz frequence voltage voltaje "
      "spannung temperatur"},
     {Label, "body part joint link barra eslabon pin gelenk point punkt punto node marker of de del von du di do"}});

} // namespace vocabulary

/// Returns whether a byte is a letter of ASCII or a part of a character outside ASCII, which counts as a letter.
bool isLetter(char c)
{
    return (lowerCase(c) >= 'a' && lowerCase(c) <= 'z') || byteOf(c) >= 0x80;
}

/// Returns whether the words are one of `names`: at least one word is in names.words, and each other word is there, in
/// names.companions, or a number.
bool areAmong(const Words &words, const ShortNames &names)
{
    const auto isListed = [&](const std::string &word) { return isAmong(word, names.words); };
    return std::ranges::any_of(words, isListed) && std::ranges::all_of(words, [&](const std::string &word) {
               return isListed(word) || isAmong(word, names.companions) || isDigits(word);
           });
}

} // namespace

const WordMeaning *findWord(std::string_view word, WordUse use)
{
    static const std::unordered_multimap<std::string_view, const WordMeaning *> kEntries = [] {
        std::unordered_multimap<std::string_view, const WordMeaning *> entries;
        for (const WordMeaning &entry : vocabulary::kRows) {
            for (std::string_view rest = entry.words; !rest.empty();) {
                entries.emplace(takeUntil(' ', rest), &entry);
            }
        }
        return entries;
    }();
    const auto [first, last] = kEntries.equal_range(word);
    const auto found = std::find_if(first, last, [use](const auto &entry) { return entry.second->use == use; });
    return found == last ? nullptr : found->second;
}

Words wordsOf(std::string_view name)
{
    // Returns whether the prime at the end of the words is a derivative and no apostrophe: it is behind a symbol such
    // as x, but not behind the elided "de" and "se" of Romance languages.
    const auto isPrimed = [](const Words &words) {
        const std::string_view symbol = words.size() > 1 ? std::string_view(words[words.size() - 2]) : "";
        return !isAmong(symbol, "d s") && findWord(symbol, WordUse::Symbol);
    };
    Words words;
    char before = ' ';
    for (const char c : kLetterSpellings.replacedIn(name)) {
        const bool startsWithCapital = lowerCase(c) != c && lowerCase(before) == before;
        const bool isApostrophe = before == '\'' && isLetter(c) && !isPrimed(words); // "d'entrée", but "x'B"
        if (isApostrophe) {
            words.pop_back();
        }
        const bool continues = isLetter(c) ? isLetter(before) && !startsWithCapital : isDigit(c) && isDigit(before);
        if (isLetter(c) || isDigit(c) || c == '\'') {
            words.resize(words.size() + (continues ? 0 : 1));
            words.back() += lowerCase(c);
        }
        before = c;
    }
    return words;
}

std::string phraseAt(const Words &words, std::size_t at, std::size_t size)
{
    std::string phrase;
    for (std::size_t i = at; i < at + size && at + size <= words.size(); ++i) {
        phrase += (i > at ? "_" : "") + words[i];
    }
    return phrase;
}

bool isDigits(std::string_view word)
{
    return !word.empty() && std::ranges::all_of(word, isDigit);
}

bool isTime(const Words &words)
{
    const bool isNumberedSymbol = words.size() > 1 && words[0] == "t" && isDigits(words[1]); // "T2", a temperature
    return (areAmong(words, kTimes) && !isNumberedSymbol) || isTimeOfDay(words);
}

bool isTimeOfDay(const Words &words)
{
    return areAmong(words, kClockWords);
}

std::string_view unitOfRotation(const Words &words)
{
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (isAmong(words[i], kTurnsPerMinute)) {
            return "rpm";
        }
        if (isAmong(words[i], kTurnsPerSecond) || isAmong(phraseAt(words, i, 2), kTurnsPerSecond)) {
            return "rps";
        }
    }
    return "";
}

bool abbreviatesMethod(const Words &words)
{
    return areAmong(words, kMethods);
}

bool namesDifferences(const Words &words)
{
    return areAmong(words, kDifferences);
}

bool namesStatistic(const Words &words)
{
    return areAmong(words, kStatistics);
}

bool namesRowNumber(const Words &words)
{
    const bool isUnnamed = words.size() == 2 && words[0] == "unnamed"; // "Unnamed: 0" of pandas
    return isUnnamed || (!words.empty() && areAmong(words, kRowNumbers) && !isDigits(words.back()));
}

bool namesOtherQuantity(std::string_view word)
{
    constexpr std::size_t kShortestPart = 4; // bytes that remain
    constexpr std::size_t kShortestStem = 5; // bytes: "blad" is an error in Polish, but not the stem of "blade"
    constexpr std::size_t kLongestEnding = 2;
    bool isOther = findWord(word, WordUse::OtherQuantity);
    // The last or the first bytes of the word are omitted.
    for (std::size_t omitted = 1; omitted + kShortestPart <= word.size(); ++omitted) {
        const std::size_t size = word.size() - omitted;
        const bool isPart = omitted > kLongestEnding || size >= kShortestStem;
        isOther = isOther || (isPart && (findWord(word.substr(omitted), WordUse::OtherQuantity) ||
                                         findWord(word.substr(0, size), WordUse::OtherQuantity)));
    }
    return isOther;
}

bool namesQuantity(const Words &words)
{
    return isTime(words) || std::ranges::any_of(words, [](const std::string &word) {
               const WordMeaning *const entry = findWord(word, WordUse::Word);
               const WordMeaning *const symbol = findWord(word, WordUse::Symbol);
               const bool isComponent = // "DX", "VX"
                   word.size() == 2 && isAmong(word.substr(0, 1), "d v a") && isAmong(word.substr(1), "x y");
               return (entry && entry->order && !entry->body) || (symbol && symbol->axis != ' ') || isComponent;
           });
}

} // namespace slidercrank
