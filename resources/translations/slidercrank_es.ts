<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>slidercrank::AnimationExport</name>
    <message>
        <source>ffmpeg could not make the video: %1</source>
        <translation>ffmpeg no pudo hacer el vídeo: %1</translation>
    </message>
    <message>
        <source>it ended without a reason.</source>
        <translation>terminó sin indicar el motivo.</translation>
    </message>
    <message>
        <source>%1: a video needs the program ffmpeg, which is not installed. Install it (Debian, Ubuntu: sudo apt install ffmpeg; Windows: winget install ffmpeg; macOS: brew install ffmpeg), or export the frames to a folder.</source>
        <translation>%1: un vídeo necesita el programa ffmpeg, que no está instalado. Instálelo (Debian, Ubuntu: sudo apt install ffmpeg; Windows: winget install ffmpeg; macOS: brew install ffmpeg) o exporte los fotogramas a una carpeta.</translation>
    </message>
    <message>
        <source>the folder cannot be created</source>
        <translation>no se puede crear la carpeta</translation>
    </message>
    <message>
        <source>it exists already</source>
        <translation>ya existe</translation>
    </message>
</context>
<context>
    <name>slidercrank::AnimationForm</name>
    <message>
        <source>Export animation</source>
        <translation>Exportar animación</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Fotogramas por segundo</translation>
    </message>
    <message>
        <source>More than %1 frames: choose a shorter length, fewer frames per second or a higher playback speed.</source>
        <translation>Más de %1 fotogramas: elija una duración menor, menos fotogramas por segundo o una velocidad de reproducción mayor.</translation>
    </message>
    <message>
        <source> s of the motion</source>
        <translation> s del movimiento</translation>
    </message>
    <message>
        <source>Videos need the program ffmpeg, which is not installed. Without it, the frames are written as pictures.</source>
        <translation>Los vídeos requieren el programa ffmpeg, que no está instalado. Sin él, los fotogramas se guardan como imágenes.</translation>
    </message>
    <message numerus="yes">
        <source>%n frames: %1 s at the playback speed of %2×.</source>
        <translation>
            <numerusform>%n fotograma: %1 s a la velocidad de reproducción de %2×.</numerusform>
            <numerusform>%n fotogramas: %1 s a la velocidad de reproducción de %2×.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>slidercrank::BackgroundTask</name>
    <message>
        <source>The computation failed: %1.</source>
        <translation>El cálculo ha fallado: %1.</translation>
    </message>
    <message>
        <source>There is not enough memory: try fewer time steps, or a smaller file.</source>
        <translation>No hay memoria suficiente: pruebe con menos pasos de tiempo o con un archivo más pequeño.</translation>
    </message>
</context>
<context>
    <name>slidercrank::CheckText</name>
    <message>
        <source>The other assembly</source>
        <translation>La otra configuración</translation>
    </message>
    <message>
        <source>The offset c with the opposite sign</source>
        <translation>La excentricidad c con el signo opuesto</translation>
    </message>
    <message>
        <source>Omitting the offset c</source>
        <translation>Omitir la excentricidad c</translation>
    </message>
    <message>
        <source>ω₂ with the opposite sign</source>
        <translation>ω₂ con el signo opuesto</translation>
    </message>
    <message>
        <source>α₂ with the opposite sign</source>
        <translation>α₂ con el signo opuesto</translation>
    </message>
    <message>
        <source>Omitting α₂</source>
        <translation>Omitir α₂</translation>
    </message>
    <message>
        <source>θ₂ with the opposite sign</source>
        <translation>θ₂ con el signo opuesto</translation>
    </message>
    <message>
        <source>Taking the degrees of θ₂ as radians (or the reverse: check the mode of the calculator)</source>
        <translation>Tomar los grados de θ₂ como radianes (o al revés: revise el modo de la calculadora)</translation>
    </message>
    <message>
        <source>Taking ω₂ in rpm as rad/s (or the reverse)</source>
        <translation>Tomar ω₂ en rpm como rad/s (o al revés)</translation>
    </message>
    <message>
        <source>Taking ω₂ in °/s as rad/s (or the reverse)</source>
        <translation>Tomar ω₂ en °/s como rad/s (o al revés)</translation>
    </message>
    <message>
        <source>Exchanging a and b</source>
        <translation>Intercambiar a y b</translation>
    </message>
    <message>
        <source>Taking twice or half the crank length a (diameter or stroke instead of radius)</source>
        <translation>Tomar el doble o la mitad de la longitud a de la manivela (diámetro o carrera en lugar del radio)</translation>
    </message>
    <message>
        <source>Measuring θ₃ clockwise</source>
        <translation>Medir θ₃ en sentido horario</translation>
    </message>
    <message>
        <source>Exchanging sine and cosine of θ₂</source>
        <translation>Intercambiar el seno y el coseno de θ₂</translation>
    </message>
    <message>
        <source>Exchanging sine and cosine of θ₃</source>
        <translation>Intercambiar el seno y el coseno de θ₃</translation>
    </message>
    <message>
        <source>ω₂ instead of ω₂²</source>
        <translation>ω₂ en lugar de ω₂²</translation>
    </message>
    <message>
        <source>Omitting the centripetal term a ω₂² of the crank</source>
        <translation>Omitir el término centrípeto a ω₂² de la manivela</translation>
    </message>
    <message>
        <source>Omitting the centripetal term b ω₃² of the coupler</source>
        <translation>Omitir el término centrípeto b ω₃² de la biela</translation>
    </message>
    <message>
        <source>Omitting both centripetal terms (a ω₂² and b ω₃²)</source>
        <translation>Omitir ambos términos centrípetos (a ω₂² y b ω₃²)</translation>
    </message>
    <message>
        <source>Simple harmonic motion (that of the crank pin A instead of the wrist pin B)</source>
        <translation>El movimiento armónico simple (el del pasador A de la manivela en lugar del pasador B)</translation>
    </message>
    <message>
        <source>θ₃ measured at A in a formula for θ₃ at B (or the reverse)</source>
        <translation>θ₃ medido en A en una fórmula para θ₃ en B (o al revés)</translation>
    </message>
    <message>
        <source>The approximation x ≈ a cos θ₂ + b − a²/4b (1 − cos 2θ₂) with its derivatives</source>
        <translation>La aproximación x ≈ a cos θ₂ + b − a²/4b (1 − cos 2θ₂), con sus derivadas,</translation>
    </message>
    <message>
        <source>sin 2θ₂/n instead of sin 2θ₂/2n in the velocity (n = b/a)</source>
        <translation>sen 2θ₂/n en lugar de sen 2θ₂/2n en la velocidad (n = b/a)</translation>
    </message>
    <message>
        <source>The centre of the coupler instead of the wrist pin B</source>
        <translation>El centro de la biela en lugar del pasador B</translation>
    </message>
    <message>
        <source>Measuring from the outer dead centre towards the crank</source>
        <translation>Medir desde el punto muerto exterior hacia la manivela</translation>
    </message>
    <message>
        <source>Measuring from the inner dead centre outwards</source>
        <translation>Medir desde el punto muerto interior hacia afuera</translation>
    </message>
    <message>
        <source>Taking inches as millimetres or centimetres (or the reverse)</source>
        <translation>Tomar pulgadas como milímetros o centímetros (o al revés)</translation>
    </message>
    <message>
        <source>Taking metres as millimetres (or the reverse)</source>
        <translation>Tomar metros como milímetros (o al revés)</translation>
    </message>
    <message>
        <source>Taking centimetres as millimetres (or the reverse)</source>
        <translation>Tomar centímetros como milímetros (o al revés)</translation>
    </message>
    <message>
        <source>Taking radians as degrees (or the reverse)</source>
        <translation>Tomar radianes como grados (o al revés)</translation>
    </message>
    <message>
        <source>The pressure angle 90° − μ instead of μ</source>
        <translation>El ángulo de presión 90° − μ en lugar de μ</translation>
    </message>
    <message>
        <source>Rounding θ₃ to three digits</source>
        <translation>Redondear θ₃ a tres cifras</translation>
    </message>
    <message>
        <source>does not exist here</source>
        <translation>no existe aquí</translation>
    </message>
    <message>
        <source>off by %1</source>
        <translation>difiere en %1</translation>
    </message>
    <message>
        <source>right to its %1 digits</source>
        <translation>correcto en sus %1 cifras</translation>
    </message>
    <message>
        <source>right to its only digit</source>
        <translation>correcto en su única cifra</translation>
    </message>
    <message>
        <source>right</source>
        <translation>correcto</translation>
    </message>
    <message>
        <source>%1, measured at B (θ₃ = θ³ + 180°)</source>
        <translation>%1, medido en B (θ₃ = θ³ + 180°)</translation>
    </message>
    <message>
        <source>%1 gives exactly your %2.</source>
        <translation>%1 da exactamente lo que usted obtuvo para %2.</translation>
    </message>
    <message>
        <source>All values are right to their last digit.</source>
        <translation>Todos los valores son correctos hasta su última cifra.</translation>
    </message>
    <message>
        <source>More than one slip is possible; more quantities or digits may decide:</source>
        <translation>Más de un descuido es posible; más magnitudes o más cifras pueden decidirlo:</translation>
    </message>
    <message>
        <source>The values have too few digits to name a slip: add digits or other quantities.</source>
        <translation>Los valores tienen muy pocas cifras para nombrar un descuido: agregue cifras u otras magnitudes.</translation>
    </message>
    <message>
        <source>The deviation is within the error of an intermediate result (θ₃, ω₃, α₃) that was rounded to three digits.</source>
        <translation>La desviación está dentro del error de un resultado intermedio (θ₃, ω₃, α₃) redondeado a tres cifras.</translation>
    </message>
    <message>
        <source>No known slip gives exactly these values.</source>
        <translation>Ningún descuido conocido da exactamente estos valores.</translation>
    </message>
    <message>
        <source>The obtuse angle 180° − μ instead of the acute μ</source>
        <translation>El ángulo obtuso 180° − μ en lugar del agudo μ</translation>
    </message>
</context>
<context>
    <name>slidercrank::ColumnMapping</name>
    <message>
        <source>ignored</source>
        <translation>sin usar</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>none given: %1</source>
        <translation>sin indicar: %1</translation>
    </message>
    <message>
        <source>as printed: %1</source>
        <translation>según el archivo: %1</translation>
    </message>
    <message>
        <source>Columns of %1</source>
        <translation>Columnas de %1</translation>
    </message>
    <message>
        <source>Use these columns</source>
        <translation>Usar estas columnas</translation>
    </message>
    <message>
        <source>Forgets what was chosen for files with these headings</source>
        <translation>Olvida lo que se eligió para los archivos con estos encabezados</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>encabezado</translation>
    </message>
    <message>
        <source>first values</source>
        <translation>primeros valores</translation>
    </message>
    <message>
        <source>read as</source>
        <translation>se lee como</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>why</source>
        <translation>motivo</translation>
    </message>
    <message>
        <source>%1 is read as</source>
        <translation>%1 se lee como</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unidad de %1</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Columnas del archivo</translation>
    </message>
    <message>
        <source>chosen by hand</source>
        <translation>elegido a mano</translation>
    </message>
    <message>
        <source>crank angle, instead of a time</source>
        <translation>ángulo de la manivela, en lugar del tiempo</translation>
    </message>
    <message>
        <source>Detect again</source>
        <translation>Detectar de nuevo</translation>
    </message>
    <message>
        <source>Choose what each column contains. The choice is remembered for files with the same headings.</source>
        <translation>Elija qué contiene cada columna. La elección se recuerda para los archivos con los mismos encabezados.</translation>
    </message>
</context>
<context>
    <name>slidercrank::ColumnText</name>
    <message>
        <source>Columns separated by “%1”</source>
        <translation>Columnas separadas por «%1»</translation>
    </message>
    <message>
        <source>%1, measured at A</source>
        <translation>%1, medido en A</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>columna %1</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>%1 (none given)</source>
        <translation>%1 (sin indicar)</translation>
    </message>
    <message>
        <source>chosen by hand</source>
        <translation>elegido a mano</translation>
    </message>
    <message>
        <source>decimal point</source>
        <translation>punto decimal</translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation>coma decimal</translation>
    </message>
    <message>
        <source>crank angle</source>
        <translation>ángulo de la manivela</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>multiples of %1</source>
        <translation>múltiplos de %1</translation>
    </message>
    <message>
        <source>recognized by its heading</source>
        <translation>reconocida por su encabezado</translation>
    </message>
    <message>
        <source>assumed: the heading names the quantity, but not the body</source>
        <translation>supuesta: el encabezado indica la magnitud, pero no el cuerpo</translation>
    </message>
    <message>
        <source>assumed from the heading: named as in Modelica or ROS, in m, rad and s</source>
        <translation>supuesta por el encabezado: se llama como en Modelica o ROS, en m, rad y s</translation>
    </message>
    <message>
        <source>assumed: no column is the time, and this is the angle of the crank</source>
        <translation>supuesta: ninguna columna es el tiempo, y esta es el ángulo de la manivela</translation>
    </message>
    <message>
        <source>the time stamps, the same in all files</source>
        <translation>los instantes, los mismos en todos los archivos</translation>
    </message>
    <message>
        <source>significant digits: %1</source>
        <translation>cifras significativas: %1</translation>
    </message>
    <message>
        <source>Joined files of one motion: %1</source>
        <translation>Archivos unidos de un mismo movimiento: %1</translation>
    </message>
    <message>
        <source>no headings</source>
        <translation>sin encabezados</translation>
    </message>
    <message>
        <source>headings in line %1</source>
        <translation>encabezados en la línea %1</translation>
    </message>
    <message>
        <source>assumed from its values: an angle that spans more than half a turn or rises evenly, or its derivative</source>
        <translation>supuesto por sus valores: un ángulo que abarca más de media vuelta o crece uniformemente, o su derivada</translation>
    </message>
    <message>
        <source>assumed from its values: of several points, only this one has a y that does not change</source>
        <translation>supuesto por sus valores: de varios puntos, solo la y de este no cambia</translation>
    </message>
    <message>
        <source>assumed: some words are unknown, but no other column is this quantity</source>
        <translation>supuesto: algunas palabras son desconocidas, pero ninguna otra columna es esta magnitud</translation>
    </message>
    <message>
        <source>assumed: the first column, whose values only increase</source>
        <translation>supuesta: la primera columna, cuyos valores solo crecen</translation>
    </message>
    <message>
        <source>%1; %2, not a derivative</source>
        <translation>%1; son %2, no una derivada</translation>
    </message>
    <message>
        <source>forward differences</source>
        <translation>diferencias hacia delante</translation>
    </message>
    <message>
        <source>backward differences</source>
        <translation>diferencias hacia atrás</translation>
    </message>
    <message>
        <source>central differences</source>
        <translation>diferencias centrales</translation>
    </message>
    <message>
        <source>Rows that were skipped: %1, the first in line %2, column %3 (“%4”): %5.</source>
        <translation>Filas omitidas: %1, la primera en la línea %2, columna %3 («%4»): %5.</translation>
    </message>
    <message>
        <source>“%1” as %2</source>
        <translation>«%1» como %2</translation>
    </message>
    <message>
        <source>Columns that were not used: %1.</source>
        <translation>Columnas que no se usaron: %1.</translation>
    </message>
    <message>
        <source>Check these columns, whose headings leave their meaning open: %1.</source>
        <translation>Compruebe estas columnas, cuyo encabezado no fija su significado: %1.</translation>
    </message>
    <message>
        <source>Every number with a decimal sign has exactly three digits after it: read as decimals, not as thousands.</source>
        <translation>Todos los números con signo decimal tienen exactamente tres cifras detrás de él: se leen como decimales, no como miles.</translation>
    </message>
    <message>
        <source>The lengths have no unit and are read as mm. If they are metres, add %1</source>
        <translation>Las longitudes no tienen unidad y se leen en mm. Si son metros, añada %1</translation>
    </message>
    <message>
        <source>The lengths have no unit and are read as mm. If they are inches, add %1</source>
        <translation>Las longitudes no tienen unidad y se leen en mm. Si son pulgadas, añada %1</translation>
    </message>
    <message>
        <source>The angles have no unit and are read in radians, as their values suggest. If they are in degrees, add %1</source>
        <translation>Los ángulos no tienen unidad y se leen en radianes, como indican sus valores. Si están en grados, añada %1</translation>
    </message>
    <message>
        <source>If this is the speed of the crank in rad/s, add %1; in turns per second, add %2</source>
        <translation>Si es la velocidad de la manivela en rad/s, añada %1; en revoluciones por segundo, añada %2</translation>
    </message>
    <message>
        <source>its unit may be rad/s or turns per second: state which one</source>
        <translation>su unidad puede ser rad/s o revoluciones por segundo: indique cuál</translation>
    </message>
    <message>
        <source>it describes the crank pin A, which is not compared</source>
        <translation>describe el pasador A de la manivela, que no se compara</translation>
    </message>
    <message>
        <source>its heading names no quantity that is compared</source>
        <translation>su encabezado no nombra ninguna magnitud que se compare</translation>
    </message>
    <message>
        <source>its heading does not name the body</source>
        <translation>su encabezado no indica el cuerpo</translation>
    </message>
    <message>
        <source>it numbers the rows</source>
        <translation>numera las filas</translation>
    </message>
    <message>
        <source>the magnitude of a vector, without its sign</source>
        <translation>es el módulo de un vector, sin su signo</translation>
    </message>
    <message>
        <source>the same time stamps as in the column of the time</source>
        <translation>los mismos instantes que en la columna del tiempo</translation>
    </message>
    <message>
        <source>the time of a clock; another column contains the time</source>
        <translation>es la hora de un reloj; otra columna contiene el tiempo</translation>
    </message>
    <message>
        <source>no heading</source>
        <translation>sin encabezado</translation>
    </message>
    <message>
        <source>it contains no number</source>
        <translation>no contiene ningún número</translation>
    </message>
    <message>
        <source>it contains more words than numbers</source>
        <translation>contiene más palabras que números</translation>
    </message>
    <message>
        <source>its unit is unknown, or does not suit the quantity</source>
        <translation>su unidad es desconocida o no corresponde a la magnitud</translation>
    </message>
    <message>
        <source>a ratio of two quantities, which is not compared</source>
        <translation>es un cociente de dos magnitudes, que no se compara</translation>
    </message>
    <message>
        <source>another column could be the same quantity</source>
        <translation>otra columna podría ser la misma magnitud</translation>
    </message>
    <message>
        <source>a derivative with respect to the crank angle, not the time: multiply it by ω₂, or by ω₂² if it is the second one</source>
        <translation>derivada respecto al ángulo de la manivela, no al tiempo: multiplíquela por ω₂, o por ω₂² si es la segunda</translation>
    </message>
    <message>
        <source>neither unit nor values tell whether it is an angle or a length</source>
        <translation>ni la unidad ni los valores dicen si es un ángulo o una longitud</translation>
    </message>
    <message>
        <source>its values do not change, like those of a parameter</source>
        <translation>sus valores no cambian, como los de un parámetro</translation>
    </message>
</context>
<context>
    <name>slidercrank::CommandLine</name>
    <message>
        <source>%1 has no value: write it after the = without a space, such as %1=9.74.</source>
        <translation>%1 no tiene valor: escríbalo después del signo = sin espacio, como %1=9.74.</translation>
    </message>
    <message>
        <source>A value must be a name, = and a number, such as x=9.74 or theta3=-154deg, not &quot;%1&quot;.</source>
        <translation>Un valor debe ser un nombre, = y un número, como x=9.74 o theta3=-154deg, no «%1».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no quantity: choose x, v, a, theta3, omega3, alpha3, displacement, mu, or a channel such as R4_x, R4_x_diff or R4_x_diff2.</source>
        <translation>«%1» no es una magnitud: elija x, v, a, theta3, omega3, alpha3, displacement, mu o un canal como R4_x, R4_x_diff o R4_x_diff2.</translation>
    </message>
    <message>
        <source>%1 is given more than once: keep one of them.</source>
        <translation>%1 se da más de una vez: deje una sola.</translation>
    </message>
    <message>
        <source>One of the arguments is empty: remove it, or name a file.</source>
        <translation>Uno de los argumentos está vacío: quítelo o indique un archivo.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; contains bytes that are not UTF-8: rename the file.</source>
        <translation>«%1» contiene bytes que no son UTF-8: cambie el nombre del archivo.</translation>
    </message>
    <message>
        <source>Give the values to be checked, such as x=9.74 v=45.1.</source>
        <translation>Indique los valores que se deben revisar, como x=9.74 v=45.1.</translation>
    </message>
    <message>
        <source>which slip gives the numbers of a calculation by hand</source>
        <translation>qué descuido da los números de un cálculo a mano</translation>
    </message>
    <message>
        <source>Checks numbers of a calculation by hand for one position of the crank (--at-angle), and names the slip that gives exactly the wrong ones. Names: x, v, a (position, velocity and acceleration of the slider), theta3, omega3, alpha3 (of the coupler), displacement (from the outer dead centre), mu (transmission angle), and every channel of solve. A number alone is in mm, degrees and s, omega3 and alpha3 also in rad/s if that is more likely; units are accepted: omega3=5.42rad/s. A number is right if the exact one rounds to it; zeros at the end of a whole number count up to the third digit. theta3 may also be measured at B, as in Norton&apos;s book. A slip is named only if it does not contradict the right numbers, if no other slip gives all wrong numbers, and if these have enough digits to exclude a coincidence.</source>
        <translation>Revisa los números de un cálculo a mano para una posición de la manivela (--at-angle) y nombra el descuido que da exactamente los erróneos. Nombres: x, v, a (posición, velocidad y aceleración de la corredera), theta3, omega3, alpha3 (de la biela), displacement (desde el punto muerto exterior), mu (ángulo de transmisión) y todo canal de solve. Un número sin unidad está en mm, grados y s, omega3 y alpha3 también en rad/s si es más probable; se aceptan unidades: omega3=5.42rad/s. Un número es correcto si el exacto se redondea a él; los ceros al final de un número entero cuentan hasta la tercera cifra. theta3 también puede medirse en B, como en el libro de Norton. Un descuido se nombra solo si no contradice los números correctos, si ningún otro da todos los números erróneos y si estos tienen cifras suficientes para excluir una coincidencia.</translation>
    </message>
    <message>
        <source>crank angle at which the values are checked (--theta20)</source>
        <translation>ángulo de la manivela en el que se revisan los valores (--theta20)</translation>
    </message>
    <message>
        <source>crank acceleration (0)</source>
        <translation>aceleración de la manivela (0)</translation>
    </message>
    <message>
        <source>--format json writes at most %1 time stamps of these channels: choose fewer --channels, or --format csv.</source>
        <translation>--format json escribe como máximo %1 instantes de estos canales: elija menos --channels, o --format csv.</translation>
    </message>
    <message>
        <source>All %1 cases together</source>
        <translation>Los %1 casos juntos</translation>
    </message>
    <message>
        <source>--%1 is given more than once: keep one of them.</source>
        <translation>--%1 se da más de una vez: deje una sola.</translation>
    </message>
    <message>
        <source>--%1 needs the name of a file.</source>
        <translation>--%1 necesita el nombre de un archivo.</translation>
    </message>
    <message>
        <source>Standard input can be read only once: give one &quot;-&quot;.</source>
        <translation>La entrada estándar solo se puede leer una vez: ponga un solo «-».</translation>
    </message>
    <message>
        <source>crank speed, constant (2π)</source>
        <translation>velocidad de la manivela, constante (2π)</translation>
    </message>
    <message>
        <source>colours (light)</source>
        <translation>colores (light)</translation>
    </message>
    <message>
        <source>Mechanism</source>
        <translation>Mecanismo</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otras</translation>
    </message>
    <message>
        <source>--%1 must be %2, not &quot;%3&quot;.</source>
        <translation>--%1 debe ser %2, y no «%3».</translation>
    </message>
    <message>
        <source>&quot;slidercrank %1&quot; takes options only: write --%2 before &quot;%3&quot;.</source>
        <translation>«slidercrank %1» solo admite opciones: escriba --%2 delante de «%3».</translation>
    </message>
    <message>
        <source>&quot;slidercrank %1&quot; takes options only: remove &quot;%2&quot;.</source>
        <translation>«slidercrank %1» solo admite opciones: quite «%2».</translation>
    </message>
    <message>
        <source>Motion of an offset slider-crank</source>
        <translation>Movimiento de un mecanismo biela-manivela descentrado</translation>
    </message>
    <message>
        <source>There would be more than %1 frames: choose a shorter --duration or a greater --speed.</source>
        <translation>Habría más de %1 fotogramas: elija una --duration menor o una --speed mayor.</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>No existe el archivo %1.</translation>
    </message>
    <message>
        <source>Model: %1</source>
        <translation>Modelo: %1</translation>
    </message>
    <message>
        <source>&quot;slidercrank %1&quot; needs a file: slidercrank %1 FILE…</source>
        <translation>«slidercrank %1» necesita un archivo: slidercrank %1 FILE…</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Velocity and acceleration do not exist at %1: the coupler is perpendicular to the slider&apos;s line there; a longer coupler (--b) avoids it.</source>
        <translation>La velocidad y la aceleración no existen en %1: allí la biela es perpendicular a la línea de la corredera; una biela más larga (--b) lo evita.</translation>
    </message>
    <message>
        <source>offset of the slider&apos;s line from O₂ (25)</source>
        <translation>excentricidad: de O₂ a la línea de la corredera (25)</translation>
    </message>
    <message>
        <source>how the motion is computed (closed-form)</source>
        <translation>cómo se calcula el movimiento (closed-form)</translation>
    </message>
    <message>
        <source>There is no help for &quot;%1&quot;: choose one of %2.</source>
        <translation>No hay ayuda sobre «%1»: elija una de %2.</translation>
    </message>
    <message>
        <source>opens the window</source>
        <translation>abre la ventana</translation>
    </message>
    <message>
        <source>the motion as CSV or JSON</source>
        <translation>el movimiento como CSV o JSON</translation>
    </message>
    <message>
        <source>dead centres, stroke, transmission angle, peaks</source>
        <translation>puntos muertos, carrera, ángulo de transmisión, máximos</translation>
    </message>
    <message>
        <source>a picture, an animation or a report</source>
        <translation>una imagen, una animación o un informe</translation>
    </message>
    <message>
        <source>Motion of an offset slider-crank. Several CSV files are read as one motion. &quot;slidercrank help COMMAND&quot; describes a command.</source>
        <translation>Movimiento de un mecanismo biela-manivela descentrado. Varios archivos CSV se leen como un solo movimiento. «slidercrank help COMMAND» describe un comando.</translation>
    </message>
    <message>
        <source>Computes the motion and writes a row for each time step: time, then the channels: positions (R1_x, R1_y, theta1, R2_x … theta4), first derivatives (theta3_diff) and second derivatives (theta3_diff2), with 17 significant digits. A value that does not exist is nan in CSV and null in JSON. A column name stands alone if its unit is mm, ° or s; any other unit follows the name: theta3_diff [rad/s].</source>
        <translation>Calcula el movimiento y escribe una fila por cada paso de tiempo: el tiempo y después los canales: posiciones (R1_x, R1_y, theta1, R2_x … theta4), primeras derivadas (theta3_diff) y segundas derivadas (theta3_diff2), con 17 cifras significativas. Un valor que no existe es nan en CSV y null en JSON. El nombre de una columna va solo si su unidad es mm, ° o s; cualquier otra unidad sigue al nombre: theta3_diff [rad/s].</translation>
    </message>
    <message>
        <source>Reads CSV files of simulations (time,R4_x,theta3_diff,…) and prints how far each column is from the model at the file&apos;s own time stamps. A value is uncertain by half a unit of its last digit and by the motion within half a unit of its time stamp. A column agrees if at least 95 % of its errors are within that bound and none exceeds ten times the bound; it is close if none exceeds a hundred times the bound; otherwise it differs. Moreover, no error of a column that agrees may exceed its bound by more than 0.5 % of half the range of the motion, and none of a close one by more than 1 %. For a file that differs, the program says what would explain the difference. A file that cannot be read is reported, and the others are still compared. FILE may be - for standard input.</source>
        <translation>Lee archivos CSV de simulaciones (time,R4_x,theta3_diff,…) e indica cuánto se aparta cada columna del modelo en los instantes del propio archivo. La incertidumbre de un valor es media unidad de su última cifra más el movimiento durante media unidad de la última cifra de su instante. Una columna coincide si al menos el 95 % de sus errores está dentro de esa cota y ninguno supera diez veces la cota; casi coincide (close) si ninguno supera cien veces la cota; en otro caso difiere. Además, ningún error de una columna que coincide puede superar su cota en más de un 0.5 % de la mitad del recorrido del movimiento, ni uno de una que casi coincide en más de un 1 %. Si un archivo difiere, el programa dice qué explicaría la diferencia. Un archivo que no se puede leer se notifica, y los demás se comparan igualmente. FILE puede ser - para la entrada estándar.</translation>
    </message>
    <message>
        <source>Times every method on the same time stamps and measures its error against the exact motion in 115 digits: the largest error of the six plotted channels, relative to the channel&apos;s peak, over the time stamps that the method reports as solved. Times depend on the machine: compare them within one run. With several cases (--cases), a table of the methods over all cases comes first: largest error, median time, and how many time steps were solved. The tables of the cases follow; --format csv has their rows, too.</source>
        <translation>Cronometra cada método en los mismos instantes y mide su error respecto al movimiento exacto con 115 cifras: el mayor error de los seis canales representados, relativo al máximo del canal, en los instantes que el método da por resueltos. Los tiempos dependen del equipo: compárelos dentro de una misma medición. Con varios casos (--cases), primero viene una tabla de los métodos para todos los casos: el error máximo, la mediana del tiempo y cuántos pasos de tiempo se resolvieron. Siguen las tablas de los casos; --format csv también da sus filas.</translation>
    </message>
    <message>
        <source>Draws what the window shows into a file, or writes a report of it. Needs no display. A scene (--scene) also supplies what the window showed: arrows, path, names, dimensions, zoom, abscissa and error measure. Without --start, --duration and --scene, the plots of a fast crank show its first revolution.</source>
        <translation>Dibuja en un archivo lo que muestra la ventana, o escribe un informe. No necesita pantalla. Una escena (--scene) aporta también lo que mostraba la ventana: flechas, trayectoria, nombres, cotas, ampliación, abscisa y medida del error. Sin --start, --duration ni --scene, las gráficas de una manivela rápida muestran su primera revolución.</translation>
    </message>
    <message>
        <source>Usage:</source>
        <translation>Uso:</translation>
    </message>
    <message>
        <source>--design computes a, b and c: remove %1.</source>
        <translation>--design calcula a, b y c: quite %1.</translation>
    </message>
    <message>
        <source>There is not enough memory: choose fewer steps or a smaller file.</source>
        <translation>No hay memoria suficiente: elija menos pasos o un archivo más pequeño.</translation>
    </message>
    <message>
        <source>There is no display for the window: set DISPLAY, or use a command, such as solve, which needs none.</source>
        <translation>No hay pantalla para la ventana: defina DISPLAY, o use un comando, como solve, que no la necesita.</translation>
    </message>
    <message>
        <source>--%1 %2: add a unit, %2deg or %2rad.</source>
        <translation>--%1 %2: añada una unidad, %2deg o %2rad.</translation>
    </message>
    <message>
        <source>The time steps are too short to be distinguished: choose fewer --steps, a longer --duration or a --start nearer to 0.</source>
        <translation>Los pasos de tiempo son demasiado cortos para distinguirse: elija menos --steps, una --duration mayor o un --start más cercano a 0.</translation>
    </message>
    <message>
        <source>--column must be a heading, = and a meaning, such as &quot;slider.s=R4_x [m]&quot;, &quot;#1=time&quot; or &quot;id=ignored&quot;, not &quot;%1&quot;.</source>
        <translation>--column debe ser un encabezado, = y un significado, como «slider.s=R4_x [m]», «#1=time» o «id=ignored», y no «%1».</translation>
    </message>
    <message>
        <source>--output would overwrite the input file %1: choose another name.</source>
        <translation>--output sobrescribiría el archivo de entrada %1: elija otro nombre.</translation>
    </message>
    <message>
        <source>Time steps</source>
        <translation>Pasos de tiempo</translation>
    </message>
    <message>
        <source>crank length O₂A (20)</source>
        <translation>longitud de la manivela O₂A (20)</translation>
    </message>
    <message>
        <source>coupler length AB (65)</source>
        <translation>longitud de la biela AB (65)</translation>
    </message>
    <message>
        <source>crank angle at t = 0, with its unit: 30deg or 0.5rad (0)</source>
        <translation>ángulo de la manivela en t = 0, con su unidad: 30deg o 0.5rad (0)</translation>
    </message>
    <message>
        <source>assembly: the slider to the right or to the left of A (open)</source>
        <translation>configuración: la corredera a la derecha o a la izquierda de A (open)</translation>
    </message>
    <message>
        <source>number of equal steps; N + 1 rows, both ends included (200)</source>
        <translation>número de pasos iguales; N + 1 filas, ambos extremos incluidos (200)</translation>
    </message>
    <message>
        <source>time span (1)</source>
        <translation>intervalo de tiempo (1)</translation>
    </message>
    <message>
        <source>first time stamp (0)</source>
        <translation>primer instante (0)</translation>
    </message>
    <message>
        <source>maximum iterations of Newton-Raphson per time step (10)</source>
        <translation>máximo de iteraciones de Newton-Raphson por paso de tiempo (10)</translation>
    </message>
    <message>
        <source>residual ‖C‖ at which Newton-Raphson stops; 0: when it no longer decreases (1e-8)</source>
        <translation>residuo ‖C‖ con el que termina Newton-Raphson; 0: cuando deja de disminuir (1e-8)</translation>
    </message>
    <message>
        <source>absolute: ‖C‖ in mm and rad; relative: lengths divided by a + b + |c| (absolute)</source>
        <translation>absolute: ‖C‖ en mm y rad; relative: longitudes divididas por a + b + |c| (absolute)</translation>
    </message>
    <message>
        <source>overrides the meaning of a column, may be repeated: &quot;slider.s=R4_x [m]&quot;, &quot;T=time [ms]&quot;, &quot;#3=ignored&quot; (the third column). A meaning is time, crank-angle, ignored or a channel; theta2 without a time is the crank angle</source>
        <translation>fija el significado de una columna, se puede repetir: «slider.s=R4_x [m]», «T=time [ms]», «#3=ignored» (la tercera columna). Un significado es time, crank-angle, ignored o un canal; theta2 sin un tiempo es el ángulo de la manivela</translation>
    </message>
    <message>
        <source>symbols in the output: absolute coordinates (θ³, Rₓ⁴), or those of textbooks (θ₃ measured at B, x_B, v_B, a_B) (absolute)</source>
        <translation>símbolos de la salida: coordenadas absolutas (θ³, Rₓ⁴), o los de los libros de texto (θ₃ medido en B, x_B, v_B, a_B) (absolute)</translation>
    </message>
    <message>
        <source>unit of the angles in the output (deg)</source>
        <translation>unidad de los ángulos de la salida (deg)</translation>
    </message>
    <message>
        <source>output format (csv)</source>
        <translation>formato de la salida (csv)</translation>
    </message>
    <message>
        <source>output format (text)</source>
        <translation>formato de la salida (text)</translation>
    </message>
    <message>
        <source>number of values of --vary (100)</source>
        <translation>número de valores de --vary (100)</translation>
    </message>
    <message>
        <source>exit with status 1 if a channel differs</source>
        <translation>termina con el código 1 si un canal difiere</translation>
    </message>
    <message>
        <source>nominal: the mechanism of the options; hard: the hard cases; all: ten ordinary cases and the hard ones; hard and all begin with the mechanism of the options if one is given (nominal)</source>
        <translation>nominal: el mecanismo de las opciones; hard: los casos difíciles; all: diez casos corrientes y los difíciles; hard y all empiezan con el mecanismo de las opciones si se da uno (nominal)</translation>
    </message>
    <message>
        <source>required: a name that ends in .png, .svg or .pdf; for frames the name of a new folder, or of a video that ends in .mp4, .webm or .gif (needs ffmpeg)</source>
        <translation>necesario: un nombre que termine en .png, .svg o .pdf; para frames el nombre de una carpeta nueva, o de un vídeo que termine en .mp4, .webm o .gif (necesita ffmpeg)</translation>
    </message>
    <message>
        <source>remove all settings that the window has stored: layout, recent files, language, notation, meanings of columns …</source>
        <translation>borra todos los ajustes que la ventana ha guardado: disposición, archivos recientes, idioma, notación, significados de columnas…</translation>
    </message>
    <message>
        <source>show this text</source>
        <translation>muestra este texto</translation>
    </message>
    <message>
        <source>show the version of the program and of its libraries</source>
        <translation>muestra la versión del programa y de sus bibliotecas</translation>
    </message>
    <message>
        <source>Cannot write to standard output: %1.</source>
        <translation>No se puede escribir en la salida estándar: %1.</translation>
    </message>
    <message>
        <source>t = %1 s lies outside the time range from %2 s to %3 s: choose another time, or another --start or --duration.</source>
        <translation>t = %1 s está fuera del intervalo de %2 s a %3 s: elija otro instante, u otro --start u otra --duration.</translation>
    </message>
    <message>
        <source>--step-angle must divide 360° into equal steps, such as 15 or 0.5, not %1.</source>
        <translation>--step-angle debe dividir 360° en pasos iguales, como 15 o 0.5, y no %1.</translation>
    </message>
    <message>
        <source>--at and --at-angle ask for one time and %1 for several: remove one of them.</source>
        <translation>--at y --at-angle piden un instante y %1 varios: quite uno de ellos.</translation>
    </message>
    <message>
        <source>--step-angle covers one revolution: remove %1.</source>
        <translation>--step-angle abarca una revolución: quite %1.</translation>
    </message>
    <message>
        <source>%1: %2; %3 time stamps</source>
        <translation>%1: %2; %3 instantes</translation>
    </message>
    <message>
        <source>The crank angle is not a finite number at %1: choose a smaller --omega2, or times nearer to 0.</source>
        <translation>El ángulo de la manivela no es un número finito en %1: elija un valor menor de --omega2, o instantes más cercanos a 0.</translation>
    </message>
    <message>
        <source>The crank angle is too large for Newton-Raphson at %1, which stores θ₂ with 16 digits: choose --method closed-form, a smaller --omega2, or times nearer to 0.</source>
        <translation>El ángulo de la manivela es demasiado grande para Newton-Raphson en %1, que guarda θ₂ con 16 cifras: elija --method closed-form, un valor menor de --omega2, o instantes más cercanos a 0.</translation>
    </message>
    <message>
        <source>Cannot write the settings in %1: remove that file.</source>
        <translation>No se pueden escribir los ajustes en %1: borre ese archivo.</translation>
    </message>
    <message>
        <source>All settings of the window are removed.</source>
        <translation>Se han borrado todos los ajustes de la ventana.</translation>
    </message>
    <message>
        <source>--reset-settings opens no window: remove the other arguments.</source>
        <translation>--reset-settings no abre ninguna ventana: quite los demás argumentos.</translation>
    </message>
    <message>
        <source>Errors are the largest of the six plotted channels, relative to the channel&apos;s peak, over the time steps that a method solves.
They are measured against a computation with 115 digits.
Machine: %1. Time: %2 s.
</source>
        <translation>Los errores son los mayores de los seis canales representados, relativos al máximo del canal, en los pasos de tiempo que un método resuelve.
Se miden respecto a un cálculo con 115 cifras.
Equipo: %1. Tiempo: %2 s.
</translation>
    </message>
    <message>
        <source>Numbers without a unit are in the unit shown; 2.5cm, 1in, 60rpm, 360deg/s, 30deg, 5ms and expressions such as 2*pi are accepted, too.</source>
        <translation>Los números sin unidad están en la unidad indicada; también se aceptan 2.5cm, 1in, 60rpm, 360deg/s, 30deg, 5ms y expresiones como 2*pi.</translation>
    </message>
    <message>
        <source>how far simulation files are from the model</source>
        <translation>cuánto se apartan del modelo los archivos de simulación</translation>
    </message>
    <message>
        <source>speed and error of every method</source>
        <translation>velocidad y error de cada método</translation>
    </message>
    <message>
        <source>read all settings from a scene that the window saved, or from a copied link; options override them</source>
        <translation>lee todos los ajustes de una escena guardada por la ventana o de un enlace copiado; las opciones prevalecen</translation>
    </message>
    <message>
        <source>read the files as parts of one motion; column numbers continue from file to file</source>
        <translation>lee los archivos como partes de un solo movimiento; los números de columna continúan de un archivo a otro</translation>
    </message>
    <message>
        <source>CSV file of a simulation; may be repeated for several files of one motion</source>
        <translation>archivo CSV de una simulación; puede repetirse para varios archivos de un movimiento</translation>
    </message>
    <message>
        <source>whether the first column holds time stamps or crank angles, which --omega2 and --theta20 convert to time</source>
        <translation>si la primera columna contiene instantes o ángulos de la manivela, que --omega2 y --theta20 convierten en tiempo</translation>
    </message>
    <message>
        <source>as --at, for the first time from --start on at which the crank is at this angle</source>
        <translation>como --at, para el primer instante desde --start en que la manivela está en este ángulo</translation>
    </message>
    <message>
        <source>for frames (30 per second): seconds of motion per second of playback (1)</source>
        <translation>para frames (30 por segundo): segundos de movimiento por segundo de reproducción (1)</translation>
    </message>
    <message>
        <source>--vary must be a parameter and a range of its values, such as b=50..120, not &quot;%1&quot;.</source>
        <translation>--vary debe ser un parámetro y un intervalo de sus valores, como b=50..120, y no «%1».</translation>
    </message>
    <message>
        <source>--%1 must be between %2 and %3, not &quot;%4&quot;.</source>
        <translation>--%1 debe estar entre %2 y %3, y no ser «%4».</translation>
    </message>
    <message>
        <source>--%1 must be a whole number, not &quot;%2&quot;.</source>
        <translation>--%1 debe ser un número entero, y no «%2».</translation>
    </message>
    <message>
        <source>--at already sets the time: remove %1.</source>
        <translation>--at ya fija el instante: quite %1.</translation>
    </message>
    <message>
        <source>--size must be width x height in pixels, such as 900x600, each at least 100, and at most %1 when multiplied by --scale, not &quot;%2&quot;.</source>
        <translation>--size debe ser ancho x alto en píxeles, como 900x600, cada uno de al menos 100 y, multiplicado por --scale, de %1 como máximo, y no «%2».</translation>
    </message>
    <message>
        <source>--column: &quot;%1&quot; is not a unit of %2.</source>
        <translation>--column: «%1» no es una unidad de %2.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
    <message>
        <source>render needs --output with a name that ends in .png, .svg or .pdf (report: .pdf; frames: a new folder, .mp4, .webm or .gif).</source>
        <translation>render necesita --output con un nombre que termine en .png, .svg o .pdf (report: .pdf; frames: una carpeta nueva, .mp4, .webm o .gif).</translation>
    </message>
    <message>
        <source>The command %1 must come first.</source>
        <translation>El comando %1 debe ir primero.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a command nor a file. The commands are %2.</source>
        <translation>«%1» no es ni un comando ni un archivo. Los comandos son %2.</translation>
    </message>
    <message>
        <source>The window does not read standard input: save it in a file, or use a command, such as compare, which reads it.</source>
        <translation>La ventana no lee la entrada estándar: guárdela en un archivo, o use un comando que la lea, como compare.</translation>
    </message>
    <message>
        <source>As options: %1</source>
        <translation>Como opciones: %1</translation>
    </message>
    <message>
        <source>%1 applies to --vary only: remove it.</source>
        <translation>%1 solo se aplica a --vary: quítelo.</translation>
    </message>
    <message>
        <source>--column gives &quot;%1&quot; two meanings: keep one of them.</source>
        <translation>--column da dos significados a «%1»: deje uno.</translation>
    </message>
    <message>
        <source>a row of limits for each of several values of a parameter: b=50..120 (CSV unless --format json)</source>
        <translation>una fila de límites por cada uno de varios valores de un parámetro: b=50..120 (CSV, salvo con --format json)</translation>
    </message>
    <message>
        <source>Frames show the whole time range: remove %1, or choose the range with --start and --duration.</source>
        <translation>Los fotogramas muestran todo el intervalo de tiempo: quite %1, o elija el intervalo con --start y --duration.</translation>
    </message>
    <message>
        <source>Only --what frames has a speed: remove %1.</source>
        <translation>Solo --what frames tiene velocidad: quite %1.</translation>
    </message>
    <message>
        <source>instead of --steps and --duration: a row for each step of this crank angle, over one revolution</source>
        <translation>en lugar de --steps y --duration: una fila por cada paso de este ángulo de la manivela, durante una revolución</translation>
    </message>
    <message>
        <source>instead of --steps and --duration: one row, for this time</source>
        <translation>en lugar de --steps y --duration: una sola fila, para este instante</translation>
    </message>
    <message>
        <source>the time that is drawn, and marked in the plots (--start)</source>
        <translation>el instante que se dibuja, marcado en las gráficas (--start)</translation>
    </message>
    <message>
        <source>write to this file instead of standard output (-)</source>
        <translation>escribe en este archivo en lugar de la salida estándar (-)</translation>
    </message>
    <message>
        <source>%1 describes a reference file: name the file with --reference.</source>
        <translation>%1 describe un archivo de referencia: indíquelo con --reference.</translation>
    </message>
    <message>
        <source>Newton-Raphson did not converge at %1: choose a greater --max-iterations (now %3) or --tolerance.</source>
        <translation>Newton-Raphson no convergió en %1: elija un valor mayor de --max-iterations (ahora %3) o de --tolerance.</translation>
    </message>
    <message>
        <source>Newton-Raphson did not converge at %1: rounding errors are larger than the --tolerance (now %4); choose a greater one.</source>
        <translation>Newton-Raphson no convergió en %1: los errores de redondeo superan la tolerancia --tolerance (ahora %4); elija una mayor.</translation>
    </message>
    <message>
        <source>Very long links need --tolerance-kind relative.</source>
        <translation>Los eslabones muy largos necesitan --tolerance-kind relative.</translation>
    </message>
    <message>
        <source>%1 of %2 time steps, first at </source>
        <translation>%1 de %2 pasos de tiempo, el primero en </translation>
    </message>
    <message>
        <source>minus</source>
        <translation>menos</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>más</translation>
    </message>
    <message>
        <source>--tolerance must be a list such as a=0.05,b=0.1,c=0.05, not &quot;%1&quot;.</source>
        <translation>--tolerance debe ser una lista como a=0.05,b=0.1,c=0.05, no «%1».</translation>
    </message>
    <message>
        <source>--design must be a list such as stroke=80,time-ratio=1.2,transmission-angle=40, or time-ratio=1.2 beside --a and --b, not &quot;%1&quot;.</source>
        <translation>--design debe ser una lista como stroke=80,time-ratio=1.2,transmission-angle=40, o time-ratio=1.2 junto con --a y --b, no «%1».</translation>
    </message>
    <message>
        <source>--design time-ratio computes c: remove %1.</source>
        <translation>--design time-ratio calcula c: quite %1.</translation>
    </message>
    <message>
        <source>--design time-ratio needs a stroke, such as stroke=80, or the lengths --a and --b.</source>
        <translation>--design time-ratio necesita una carrera, por ejemplo stroke=80, o las longitudes --a y --b.</translation>
    </message>
    <message>
        <source>--tolerance: the tolerance of %1 must be smaller than %1 = %2 mm, not &quot;%3&quot;.</source>
        <translation>--tolerance: la tolerancia de %1 debe ser menor que %1 = %2 mm, no «%3».</translation>
    </message>
    <message>
        <source>--vary sets the values of this parameter: remove %1.</source>
        <translation>--vary da los valores de este parámetro: quite %1.</translation>
    </message>
    <message>
        <source>--vary prints values without their tolerances: remove %1.</source>
        <translation>--vary escribe valores sin sus tolerancias: quite %1.</translation>
    </message>
    <message>
        <source>The crank does not reach %1° within 1e12 s: choose a different --omega2 or --theta20.</source>
        <translation>La manivela no alcanza %1° en menos de 1e12 s: elija otro valor de --omega2 o de --theta20.</translation>
    </message>
    <message>
        <source>Prints whether the crank makes full turns and why, the dead centres, the stroke, angles and times of both strokes, the time ratio, the extremes of the transmission angle and of the coupler angle, mean and peak speeds and peak accelerations, and where and when they occur. Crank angles in JSON and CSV are in degrees. The exit status is 4 if the mechanism cannot be assembled at all.</source>
        <translation>Escribe si la manivela da vueltas completas y por qué, los puntos muertos, la carrera, los ángulos y tiempos de ambas carreras, la relación de tiempos, los valores extremos del ángulo de transmisión y del ángulo de la biela, las velocidades medias y máximas y las aceleraciones máximas, y dónde y cuándo se dan. Los ángulos de la manivela en JSON y CSV están en grados. El código de salida es 4 si el mecanismo no se puede ensamblar en ninguna posición.</translation>
    </message>
    <message>
        <source>a row for each position of one revolution in which a quantity has this value: x=60, theta3=10deg, v=-0.2m/s, or any channel</source>
        <translation>una fila por cada posición de una revolución en la que una magnitud tiene este valor: x=60, theta3=10deg, v=-0.2m/s, o cualquier canal</translation>
    </message>
    <message>
        <source>crank acceleration at the positions of --at, --at-angle, --step-angle or --when (0): a channel f has the second derivative f″ω₂² + f′α₂</source>
        <translation>aceleración de la manivela en las posiciones de --at, --at-angle, --step-angle o --when (0): un canal f tiene la segunda derivada f″ω₂² + f′α₂</translation>
    </message>
    <message>
        <source>with --at-angle: compute the crank speed at which a first derivative has this value, and report it: v=8m/s</source>
        <translation>con --at-angle: calcula la velocidad de la manivela con la que una primera derivada tiene este valor, y la indica: v=8m/s</translation>
    </message>
    <message>
        <source>find the mechanism with this stroke, this time ratio (1) and at least this minimum transmission angle: stroke=80,time-ratio=1.2,transmission-angle=40; if several are possible, the one with the largest angle is chosen. With time-ratio alone, and with --a and --b: find the offset c</source>
        <translation>busca el mecanismo con esta carrera, esta relación de tiempos (1) y al menos este ángulo de transmisión mínimo: stroke=80,time-ratio=1.2,transmission-angle=40; si hay varios, elige el de mayor ángulo. Solo con time-ratio, y con --a y --b: busca la excentricidad c</translation>
    </message>
    <message>
        <source>a=0.05,b=0.1,c=0.05: how much each limit may decrease and increase if the lengths deviate by this much (mm)</source>
        <translation>a=0.05,b=0.1,c=0.05: cuánto puede disminuir y aumentar cada límite si las longitudes se desvían esto (mm)</translation>
    </message>
    <message>
        <source>--%1 must be a channel, = and its value, such as %2, not &quot;%3&quot;.</source>
        <translation>--%1 debe ser un canal, = y su valor, como %2, no «%3».</translation>
    </message>
    <message>
        <source>A revolution of the crank takes more than 1e12 s: choose a larger --omega2.</source>
        <translation>Una revolución de la manivela dura más de 1e12 s: elija un valor mayor de --omega2.</translation>
    </message>
    <message>
        <source>The rows are too close in time to be distinguished: choose a larger --step-angle, a smaller --omega2 or a --start nearer to 0.</source>
        <translation>Las filas están demasiado próximas en el tiempo para distinguirlas: elija un valor mayor de --step-angle, uno menor de --omega2 o un --start más próximo a 0.</translation>
    </message>
    <message>
        <source>--when: the crank stands still, so that %1 is 0 everywhere.</source>
        <translation>--when: la manivela está en reposo, de modo que %1 es 0 en todas partes.</translation>
    </message>
    <message>
        <source>--when: %1 does not depend on the crank angle.</source>
        <translation>--when: %1 no depende del ángulo de la manivela.</translation>
    </message>
    <message>
        <source>There is no position with %1 = %2: &quot;slidercrank limits&quot; shows how far the motion goes.</source>
        <translation>No hay ninguna posición con %1 = %2: «slidercrank limits» muestra hasta dónde llega el movimiento.</translation>
    </message>
    <message>
        <source>There is no position with %1 = %2, because %1 is measured at A. If %2 is the angle at B, as in Norton&apos;s book, write %1=%3.</source>
        <translation>No hay ninguna posición con %1 = %2, porque %1 se mide en A. Si %2 es el ángulo en B, como en el libro de Norton, escriba %1=%3.</translation>
    </message>
    <message>
        <source>--omega2-for computes the crank speed: remove %1.</source>
        <translation>--omega2-for calcula la velocidad de la manivela: quite %1.</translation>
    </message>
    <message>
        <source>--omega2-for needs a first derivative, such as R4_x_diff=8m/s, not %1.</source>
        <translation>--omega2-for necesita una primera derivada, como R4_x_diff=8m/s, no %1.</translation>
    </message>
    <message>
        <source>No crank speed gives %1 = %2 at %3°: there %1 is 0 at every speed, as at a dead centre, or does not exist.</source>
        <translation>Ninguna velocidad de la manivela da %1 = %2 a %3°: allí %1 es 0 a cualquier velocidad, como en un punto muerto, o no existe.</translation>
    </message>
    <message>
        <source>--when covers one revolution: remove %1.</source>
        <translation>--when abarca una revolución: quite %1.</translation>
    </message>
    <message>
        <source>%1 needs the position: add --at-angle.</source>
        <translation>%1 necesita la posición: añada --at-angle.</translation>
    </message>
    <message>
        <source>The crank has a constant speed over time, and %1 applies to single positions: add --at-angle, --at, --step-angle or --when.</source>
        <translation>La manivela tiene velocidad constante en el tiempo, y %1 se aplica a posiciones sueltas: añada --at-angle, --at, --step-angle o --when.</translation>
    </message>
    <message>
        <source>factor of the number of pixels of a PNG, 0.1 to 10 (1)</source>
        <translation>factor del número de píxeles de un PNG, de 0.1 a 10 (1)</translation>
    </message>
    <message>
        <source>width of a picture in mm or px, such as 85mm or 1200px; the height follows (160mm, at 300 dots per inch)</source>
        <translation>ancho de la imagen en mm o px, por ejemplo 85mm o 1200px; la altura resulta del contenido (160mm, a 300 puntos por pulgada)</translation>
    </message>
    <message>
        <source>size of the letters in a picture, such as 10pt (9pt)</source>
        <translation>tamaño de letra de la imagen, por ejemplo 10pt (9pt)</translation>
    </message>
    <message>
        <source>the plots of the figure, separated by commas: channels, error_position, error_velocity, error_acceleration (all)</source>
        <translation>las gráficas de la figura, separadas por comas: canales, error_position, error_velocity, error_acceleration (todas)</translation>
    </message>
    <message>
        <source>do not write the values at the time of --at in the plots</source>
        <translation>no escribir en las gráficas los valores en el instante de --at</translation>
    </message>
    <message>
        <source>paper of a report (a4)</source>
        <translation>papel del informe (a4)</translation>
    </message>
    <message>
        <source>--plots chooses among the plots of the figure: use it without --what.</source>
        <translation>--plots elige entre las gráficas de la figura: utilícela sin --what.</translation>
    </message>
    <message>
        <source>--%1 must be a number with the unit %2, not &quot;%3&quot;.</source>
        <translation>--%1 debe ser un número con la unidad %2, no «%3».</translation>
    </message>
    <message>
        <source>--%1 must be between %2 and %3 %4.</source>
        <translation>--%1 debe estar entre %2 y %3 %4.</translation>
    </message>
    <message>
        <source>--size and %1 both state the width: remove one of them.</source>
        <translation>--size y %1 indican el ancho: elimine una de las dos.</translation>
    </message>
    <message>
        <source>A report has a fixed layout, black on white: remove %1.</source>
        <translation>El informe tiene un formato fijo, negro sobre blanco: elimine %1.</translation>
    </message>
    <message>
        <source>Only a report has a paper size: remove %1.</source>
        <translation>Solo el informe tiene tamaño de papel: elimine %1.</translation>
    </message>
    <message>
        <source>Frames have a --size: remove %1.</source>
        <translation>El tamaño de los fotogramas se indica con --size: elimine %1.</translation>
    </message>
    <message>
        <source>pixels of a picture, instead of --width (frames: 1920x1080)</source>
        <translation>píxeles de la imagen, en lugar de --width (fotogramas: 1920x1080)</translation>
    </message>
    <message>
        <source>the mechanism that produced each file</source>
        <translation>el mecanismo que produjo los datos de cada archivo</translation>
    </message>
    <message>
        <source>Identifies the mechanism that produced a file, from all of its columns, and how certain each parameter is (± one standard error). If the meaning of a column differs from its heading (radians, a different origin or sign …), the program reports that and reads the file accordingly. The options of the mechanism supply what the file does not determine. R4_x and R4_y are measured from the crank pivot O₂, angles counter-clockwise from x. FILE may be - for standard input. Outcomes: identified (rounding explains every column that is used), approximate (a mechanism explains the file with residuals below 2 % of the range), insufficient (the file does not determine the mechanism), none (no mechanism explains the file).</source>
        <translation>Identifica el mecanismo que produjo los datos de un archivo, a partir de todas sus columnas, y la certeza de cada parámetro (± un error estándar). Si el significado de una columna difiere de su encabezado (radianes, un origen o un signo distintos …), el programa lo indica y lee así el archivo. Las opciones del mecanismo aportan lo que el archivo no determina. R4_x y R4_y se miden desde el pivote O₂ de la manivela; los ángulos, en sentido antihorario desde x. FILE puede ser - para la entrada estándar. Resultados: identified (el redondeo explica todas las columnas que se usan), approximate (un mecanismo explica el archivo con residuos menores que el 2 % del intervalo de valores), insufficient (el archivo no determina el mecanismo), none (ningún mecanismo explica el archivo).</translation>
    </message>
    <message>
        <source>The mechanism cannot be assembled at %1: the coupler must be at least %2 long for the crank to make full turns (--b).</source>
        <translation>El mecanismo no se puede ensamblar en %1: la biela debe medir al menos %2 para que la manivela dé vueltas completas (--b).</translation>
    </message>
    <message>
        <source>unit of the lengths in the output (mm)</source>
        <translation>unidad de las longitudes en la salida (mm)</translation>
    </message>
    <message>
        <source>unit of the checked angles, if they are written without one (deg)</source>
        <translation>unidad de los ángulos que se comprueban, si se escriben sin ella (deg)</translation>
    </message>
    <message>
        <source>unit of the checked lengths, if they are written without one (mm); --a, --b and --c remain in mm</source>
        <translation>unidad de las longitudes que se comprueban, si se escriben sin ella (mm); --a, --b y --c siguen en mm</translation>
    </message>
    <message>
        <source>--help describes the options.</source>
        <translation>--help describe las opciones.</translation>
    </message>
    <message>
        <source>Did you mean %1?</source>
        <translation>¿Quiso decir %1?</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2, %n rows</source>
        <translation>
            <numerusform>%1: %2, %n fila</numerusform>
            <numerusform>%1: %2, %n filas</numerusform>
        </translation>
    </message>
    <message>
        <source>crank acceleration in the values of a report, in polygons, and in the arrows that a scene draws (0)</source>
        <translation>aceleración de la manivela en los valores de un informe, en los polígonos y en las flechas que una escena dibuja (0)</translation>
    </message>
    <message>
        <source>step of the table in a report (15)</source>
        <translation>paso de la tabla de un informe (15)</translation>
    </message>
    <message>
        <source>figure (all plots), mechanism, polygons (of velocity and acceleration), frames (the mechanism moving), report, or one plot: theta3, R4_x, theta3_diff, R4_x_diff, theta3_diff2, R4_x_diff2, error_position, error_velocity, error_acceleration (figure)</source>
        <translation>figure (todas las gráficas), mechanism, polygons (de velocidad y aceleración), frames (el mecanismo en movimiento), report, o una gráfica: theta3, R4_x, theta3_diff, R4_x_diff, theta3_diff2, R4_x_diff2, error_position, error_velocity, error_acceleration (figure)</translation>
    </message>
    <message>
        <source>coupler angles in the text: absolute coordinates (θ³ at A), or those of textbooks (θ₃ at B) (absolute)</source>
        <translation>ángulos de la biela en el texto: coordenadas absolutas (θ³ en A), o los de los libros de texto (θ₃ en B) (absolute)</translation>
    </message>
    <message>
        <source>Exit status: 0 success; 1 --fail-on-difference was given and a channel differs, or a value to be checked is wrong; 2 usage error; 3 a file cannot be read or written; 4 the mechanism cannot be assembled at some time step (the other steps are still written), or a request of --design, --when or --omega2-for is impossible; 5 not converged or singular at some time step, or no mechanism identified. If several apply, the first of 3, 4, 5, 1 is returned.</source>
        <translation>Código de salida: 0 correcto; 1 se dio --fail-on-difference y un canal difiere, o un valor revisado es erróneo; 2 error de uso; 3 un archivo no se puede leer o escribir; 4 el mecanismo no se puede ensamblar en algún paso de tiempo (los demás se escriben igualmente), o lo que se pide con --design, --when u --omega2-for es imposible; 5 sin convergencia o singular en algún paso de tiempo, o ningún mecanismo identificado. Si se dan varios, se devuelve el primero de 3, 4, 5, 1.</translation>
    </message>
    <message>
        <source>%1%2 %3: write the number and its unit without a space, %2%3.</source>
        <translation>%1%2 %3: escriba el número y su unidad sin espacio, %2%3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an option: write --%2 %3.</source>
        <translation>«%1» no es una opción: escriba --%2 %3.</translation>
    </message>
    <message>
        <source>all, or names separated by commas: theta3,R4_x_diff (all); also transmission_angle, displacement (from the outer dead centre), A_x and A_y, with _diff and _diff2. The columns have the order of all, not that of the names</source>
        <translation>all, o nombres separados por comas: theta3,R4_x_diff (all); también transmission_angle, displacement (desde el punto muerto exterior), A_x y A_y, con _diff y _diff2. Las columnas tienen el orden de all, no el de los nombres</translation>
    </message>
    <message>
        <source>There is no position with %1 = %2: %1 lies between %3 and %4.</source>
        <translation>No hay ninguna posición con %1 = %2: %1 está entre %3 y %4.</translation>
    </message>
    <message>
        <source>--tolerance: &quot;%1&quot; is not one of the lengths a, b and c.</source>
        <translation>--tolerance: «%1» no es ninguna de las longitudes a, b y c.</translation>
    </message>
    <message>
        <source>--tolerance gives %1 twice: keep one of them.</source>
        <translation>--tolerance indica %1 dos veces: deje solo una.</translation>
    </message>
    <message>
        <source>--vary: &quot;%1&quot; is no parameter: choose a, b, c, omega2 or theta20.</source>
        <translation>--vary: «%1» no es un parámetro: elija a, b, c, omega2 o theta20.</translation>
    </message>
    <message>
        <source>Only a report, polygons and a scene with arrows of acceleration show an acceleration of the crank, and everything else is for a constant crank speed: remove %1.</source>
        <translation>Solo el informe, los polígonos y una escena con flechas de aceleración muestran una aceleración de la manivela; todo lo demás es para una velocidad constante: quite %1.</translation>
    </message>
    <message>
        <source>Only a report contains a table: remove %1.</source>
        <translation>Solo un informe contiene una tabla: quite %1.</translation>
    </message>
    <message>
        <source>A report of a comparison contains no table: remove %1.</source>
        <translation>El informe de una comparación no contiene ninguna tabla: quite %1.</translation>
    </message>
    <message>
        <source>The velocities jump at %1 (rows: %2), where the coupler is perpendicular to the slider&apos;s line: velocities and accelerations there are those of one side only.</source>
        <translation>Las velocidades dan un salto en %1 (filas: %2), donde la biela es perpendicular a la línea de la corredera: las velocidades y aceleraciones de allí son solo las de un lado.</translation>
    </message>
</context>
<context>
    <name>slidercrank::ConventionText</name>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>radianes</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>{columns}: jumps by whole turns.</source>
        <translation>{columns}: tiene saltos de vueltas enteras.</translation>
    </message>
    <message>
        <source>{columns}: with the opposite sign.</source>
        <translation>{columns}: con el signo contrario.</translation>
    </message>
    <message>
        <source>{columns}: not the time derivative of the position column.</source>
        <translation>{columns}: no es la derivada temporal de la columna de posición.</translation>
    </message>
    <message>
        <source>The slider moves along y instead of x, as in an upright engine.</source>
        <translation>La corredera se mueve a lo largo de y en lugar de x, como en un motor vertical.</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>milisegundos</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>minutos</translation>
    </message>
    <message>
        <source>microseconds</source>
        <translation>microsegundos</translation>
    </message>
    <message>
        <source>in seconds, but read in a different unit</source>
        <translation>en segundos, pero leído en otra unidad</translation>
    </message>
    <message>
        <source>in millimetres, but read in a different unit</source>
        <translation>en milímetros, pero leído en otra unidad</translation>
    </message>
    <message>
        <source>in %1, but read as %2</source>
        <translation>en %1, pero leído como %2</translation>
    </message>
    <message>
        <source>The time is {units}.</source>
        <translation>El tiempo está {units}.</translation>
    </message>
    <message>
        <source>%1 Largest error: %2 → %3 % of peak.</source>
        <translation>%1 Error máximo: %2 → %3 % del máximo.</translation>
    </message>
    <message>
        <source>%1: finite differences, not the time derivative.</source>
        <translation>%1: diferencias finitas, no la derivada temporal.</translation>
    </message>
    <message>
        <source>{columns}: the headings are swapped.</source>
        <translation>{columns}: los encabezados están intercambiados.</translation>
    </message>
    <message>
        <source>The mechanism that produced the file has the other assembly: its slider is on the other side of A.</source>
        <translation>El mecanismo que produjo los datos tiene la otra configuración: su corredera está al otro lado de A.</translation>
    </message>
    <message>
        <source>{columns}: measured from the opposite direction; {symbol} = value in the file {shift}.</source>
        <translation>{columns}: medido desde la dirección opuesta; {symbol} = valor del archivo {shift}.</translation>
    </message>
    <message>
        <source>{columns}: off by whole turns; {symbol} = value in the file {shift}.</source>
        <translation>{columns}: difiere en vueltas enteras; {symbol} = valor del archivo {shift}.</translation>
    </message>
    <message>
        <source>{columns}: measured from a different origin; the zero of the file is at {symbol} = {value}.</source>
        <translation>{columns}: medido desde un origen distinto; el cero del archivo está en {symbol} = {value}.</translation>
    </message>
    <message>
        <source>{columns}: the angle of the coupler seen from B, as textbooks draw θ₃; {symbol} = value in the file {shift}.</source>
        <translation>{columns}: el ángulo de la biela visto desde B, como dibujan θ₃ los libros de texto; {symbol} = valor del archivo {shift}.</translation>
    </message>
    <message>
        <source>The time stamps are shifted: t = time in the file {shift}.</source>
        <translation>Los instantes están desplazados: t = tiempo del archivo {shift}.</translation>
    </message>
</context>
<context>
    <name>slidercrank::DesignForm</name>
    <message>
        <source>Mechanism with a given stroke and time ratio</source>
        <translation>Mecanismo con una carrera y una relación de tiempos dadas</translation>
    </message>
    <message>
        <source>Type a stroke: the mechanism is scaled; its time ratio and its angles do not change</source>
        <translation>Escriba una carrera: el mecanismo se escala; su relación de tiempos y sus ángulos no cambian</translation>
    </message>
    <message>
        <source>Type a time ratio: the mechanism with the largest minimum transmission angle is chosen, the stroke stays. A ratio below 1 exchanges the forward and the return stroke.</source>
        <translation>Escriba una relación de tiempos: se elige el mecanismo con el mayor ángulo de transmisión mínimo y se conserva la carrera. Una relación menor que 1 intercambia la carrera de ida y la de retorno.</translation>
    </message>
    <message>
        <source>Type the smallest transmission angle that you accept: the mechanism with the largest minimum transmission angle is chosen, stroke and time ratio stay</source>
        <translation>Escriba el menor ángulo de transmisión que acepta: se elige el mecanismo con el mayor ángulo de transmisión mínimo y se conservan la carrera y la relación de tiempos</translation>
    </message>
    <message>
        <source>The remaining degree of freedom: the ratio b/a of coupler and crank</source>
        <translation>El grado de libertad restante: la relación b/a entre biela y manivela</translation>
    </message>
    <message>
        <source>Best transmission angle</source>
        <translation>Mejor ángulo de transmisión</translation>
    </message>
    <message>
        <source>The ratio b/a with the largest minimum transmission angle, at most %1</source>
        <translation>La relación b/a con el mayor ángulo de transmisión mínimo, como máximo %1</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Carrera</translation>
    </message>
    <message>
        <source>Time ratio</source>
        <translation>Relación de tiempos</translation>
    </message>
    <message>
        <source>Ratio b/a</source>
        <translation>Relación b/a</translation>
    </message>
    <message>
        <source>The crank does not make full turns: there is no time ratio.</source>
        <translation>La manivela no da vueltas completas: no hay relación de tiempos.</translation>
    </message>
    <message>
        <source>With this time ratio the minimum transmission angle is largest, %1, for b/a = %2.</source>
        <translation>Con esta relación de tiempos, el ángulo de transmisión mínimo alcanza su máximo, %1, con b/a = %2.</translation>
    </message>
    <message>
        <source>Minimum transmission angle</source>
        <translation>Ángulo de transmisión mínimo</translation>
    </message>
    <message>
        <source>b/a = %1.</source>
        <translation>b/a = %1.</translation>
    </message>
    <message>
        <source>keep a and b</source>
        <translation>conservar a y b</translation>
    </message>
    <message>
        <source>A time ratio changes the offset c alone; the stroke follows</source>
        <translation>La relación de tiempos cambia solo la excentricidad c; la carrera resulta de ella</translation>
    </message>
</context>
<context>
    <name>slidercrank::DesignText</name>
    <message>
        <source>The stroke must be greater than 0.</source>
        <translation>La carrera debe ser mayor que 0.</translation>
    </message>
    <message>
        <source>There is no such mechanism: a crank that makes full turns has a time ratio below 3, not %1.</source>
        <translation>No existe tal mecanismo: una manivela que da vueltas completas tiene una relación de tiempos menor que 3, no %1.</translation>
    </message>
    <message>
        <source>There is no such mechanism: with a time ratio of %1 the minimum transmission angle is at most %2°; an angle of %3° needs a time ratio below %4.</source>
        <translation>No existe tal mecanismo: con una relación de tiempos de %1, el ángulo de transmisión mínimo es como máximo %2°; un ángulo de %3° exige una relación de tiempos menor que %4.</translation>
    </message>
    <message>
        <source>There is no such mechanism: every minimum transmission angle is below 90°.</source>
        <translation>No existe tal mecanismo: todo ángulo de transmisión mínimo es menor que 90°.</translation>
    </message>
    <message>
        <source>There is no such mechanism: the coupler b must be longer than the crank a.</source>
        <translation>No existe tal mecanismo: la biela b debe ser más larga que la manivela a.</translation>
    </message>
    <message>
        <source>There is no such mechanism: with these lengths a and b the time ratio is below %1, not %2.</source>
        <translation>No existe tal mecanismo: con estas longitudes a y b la relación de tiempos es menor que %1, no %2.</translation>
    </message>
</context>
<context>
    <name>slidercrank::EditStack</name>
    <message>
        <source>change of the mechanism</source>
        <translation>cambio del mecanismo</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>cambio de %1</translation>
    </message>
    <message>
        <source>closing of %1</source>
        <translation>cierre de %1</translation>
    </message>
    <message>
        <source>opening of %1</source>
        <translation>apertura de %1</translation>
    </message>
    <message>
        <source>change of the time range</source>
        <translation>cambio del intervalo de tiempo</translation>
    </message>
    <message>
        <source>change of the method</source>
        <translation>cambio del método</translation>
    </message>
    <message>
        <source>pinning of the motion</source>
        <translation>fijación del movimiento</translation>
    </message>
    <message>
        <source>removal of the pinned motions</source>
        <translation>eliminación de los movimientos fijados</translation>
    </message>
    <message>
        <source>use of the file&apos;s mechanism</source>
        <translation>uso del mecanismo del archivo</translation>
    </message>
    <message>
        <source>cancelling</source>
        <translation>cancelación</translation>
    </message>
    <message>
        <source>new interpretation of %1</source>
        <translation>otra interpretación de %1</translation>
    </message>
</context>
<context>
    <name>slidercrank::ErrorPage</name>
    <message>
        <source>agrees</source>
        <translation>coincide</translation>
    </message>
    <message>
        <source>close</source>
        <translation>casi coincide</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>difiere</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>magnitud</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Lo que se compara</translation>
    </message>
    <message>
        <source>t [s]</source>
        <translation>t [s]</translation>
    </message>
    <message>
        <source>Time of the largest error</source>
        <translation>Instante del error máximo</translation>
    </message>
    <message>
        <source>% of peak</source>
        <translation>% del máximo</translation>
    </message>
    <message>
        <source>Largest error relative to the largest value of the reference</source>
        <translation>Error máximo relativo al mayor valor de la referencia</translation>
    </message>
    <message>
        <source>Errors, a row for each channel</source>
        <translation>Errores, una fila por canal</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>veredicto</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>error máximo</translation>
    </message>
    <message>
        <source>max |model − reference|</source>
        <translation>máx. |modelo − referencia|</translation>
    </message>
    <message>
        <source>This mechanism is the pinned one: change it to see the difference.</source>
        <translation>Este mecanismo es el fijado: cámbielo para ver la diferencia.</translation>
    </message>
    <message>
        <source>Time steps at which one of the two mechanisms cannot be assembled are not compared.</source>
        <translation>Los pasos de tiempo en que uno de los dos mecanismos no se puede ensamblar no se comparan.</translation>
    </message>
    <message>
        <source>Differences from the pinned motion, a row for each channel</source>
        <translation>Diferencias con el movimiento fijado, una fila por canal</translation>
    </message>
    <message>
        <source>largest difference</source>
        <translation>diferencia máxima</translation>
    </message>
    <message>
        <source>max |this − pinned|</source>
        <translation>máx. |este − fijado|</translation>
    </message>
    <message>
        <source>Use this mechanism</source>
        <translation>Usar este mecanismo</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>There is nothing to compare with: no file is open and no motion is pinned. Edit &gt; Pin this motion keeps the present curves.</source>
        <translation>No hay nada con que comparar: no hay ningún archivo abierto ni movimiento fijado. Editar &gt; Fijar este movimiento conserva las curvas actuales.</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Errores</translation>
    </message>
    <message>
        <source>Rounding: half a unit of the last digit of the value, plus the motion during half a unit of the last digit of the time stamp
agrees: at least 95 % of the errors are within the rounding, and none exceeds it tenfold or by more than 0.5 % of half the range of the motion
close: none exceeds it a hundredfold or by more than 1 % of half that range
differs: anything else</source>
        <translation>Redondeo: media unidad de la última cifra del valor, más el movimiento durante media unidad de la última cifra del instante
coincide: al menos el 95 % de los errores está dentro del redondeo y ninguno lo supera diez veces ni en más del 0,5 % de la mitad del recorrido del movimiento
casi coincide: ninguno lo supera cien veces ni en más del 1 % de la mitad del recorrido
difiere: lo demás</translation>
    </message>
    <message>
        <source>The mechanism cannot be assembled at %1 time steps of the file.</source>
        <translation>El mecanismo no se puede ensamblar en %1 instantes del archivo.</translation>
    </message>
    <message>
        <source>Root mean square: %1 %2</source>
        <translation>Valor medio cuadrático (RMS): %1 %2</translation>
    </message>
    <message>
        <source>Rows that were skipped: %1.</source>
        <translation>Filas omitidas: %1.</translation>
    </message>
    <message>
        <source>Sets %1.</source>
        <translation>Establece %1.</translation>
    </message>
    <message>
        <source>These corrections are applied to the file: %1</source>
        <translation>Estas correcciones se aplican al archivo: %1</translation>
    </message>
    <message>
        <source>Remove corrections</source>
        <translation>Quitar correcciones</translation>
    </message>
    <message>
        <source>Infinite: one of the two mechanisms reaches a limit position</source>
        <translation>Infinita: uno de los dos mecanismos alcanza una posición límite</translation>
    </message>
    <message>
        <source>Difference: this mechanism minus the pinned one (%1).</source>
        <translation>Diferencia: este mecanismo menos el fijado (%1).</translation>
    </message>
    <message>
        <source>Columns that were not used: %1.</source>
        <translation>Columnas no usadas: %1.</translation>
    </message>
    <message>
        <source>See the tab Reference.</source>
        <translation>Véase la pestaña Referencia.</translation>
    </message>
    <message>
        <source>Open a CSV…</source>
        <translation>Abrir un CSV…</translation>
    </message>
</context>
<context>
    <name>slidercrank::ExplanationText</name>
    <message>
        <source>Over the crank angle, the file agrees with this mechanism.</source>
        <translation>En función del ángulo de la manivela, el archivo coincide con este mecanismo.</translation>
    </message>
    <message>
        <source>The other columns agree with this mechanism.</source>
        <translation>Las demás columnas coinciden con este mecanismo.</translation>
    </message>
    <message>
        <source>The other rows agree with this mechanism.</source>
        <translation>Las demás filas coinciden con este mecanismo.</translation>
    </message>
    <message>
        <source>With these corrections, the file agrees with this mechanism.</source>
        <translation>Con estas correcciones, el archivo coincide con este mecanismo.</translation>
    </message>
</context>
<context>
    <name>slidercrank::Exports</name>
    <message>
        <source>The six channels of the plots (*.csv)</source>
        <translation>Los seis canales de las gráficas (*.csv)</translation>
    </message>
    <message>
        <source>Export data</source>
        <translation>Exportar datos</translation>
    </message>
    <message>
        <source>All 36 channels (*.csv)</source>
        <translation>Los 36 canales (*.csv)</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Exportar informe</translation>
    </message>
    <message>
        <source>Export animation</source>
        <translation>Exportar animación</translation>
    </message>
    <message>
        <source>Another file is still being written: wait for it, or cancel it below.</source>
        <translation>Todavía se está escribiendo otro archivo: espere a que termine, o cancélelo abajo.</translation>
    </message>
    <message>
        <source>New folder of numbered frames (*)</source>
        <translation>Carpeta nueva de fotogramas numerados (*)</translation>
    </message>
    <message>
        <source>Videos (*.mp4)</source>
        <translation>Vídeos (*.mp4)</translation>
    </message>
    <message>
        <source>Videos (*.webm)</source>
        <translation>Vídeos (*.webm)</translation>
    </message>
    <message>
        <source>Animated pictures (*.gif)</source>
        <translation>Imágenes animadas (*.gif)</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>movimiento</translation>
    </message>
    <message>
        <source>Exporting the animation…</source>
        <translation>Exportando la animación…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>La imagen está en el portapapeles.</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>figura</translation>
    </message>
    <message>
        <source>mechanism</source>
        <translation>mecanismo</translation>
    </message>
    <message>
        <source>report</source>
        <translation>informe</translation>
    </message>
    <message>
        <source>No report was written: the mechanism of the file is still being identified. Export it again in a moment.</source>
        <translation>No se escribió el informe: todavía se está identificando el mecanismo del archivo. Expórtelo de nuevo dentro de un momento.</translation>
    </message>
    <message>
        <source>Reports on A4 (*.pdf)</source>
        <translation>Informes en A4 (*.pdf)</translation>
    </message>
    <message>
        <source>Reports on Letter (*.pdf)</source>
        <translation>Informes en tamaño carta (*.pdf)</translation>
    </message>
</context>
<context>
    <name>slidercrank::FigureExportText</name>
    <message>
        <source>%1: a figure&apos;s name must end in .png, .svg or .pdf.</source>
        <translation>%1: el nombre de una figura debe terminar en .png, .svg o .pdf.</translation>
    </message>
    <message>
        <source>A figure of %1 × %2 pixels at scale %3 is too small or too large: choose another size or scale.</source>
        <translation>Una figura de %1 × %2 píxeles a escala %3 es demasiado pequeña o demasiado grande: elija otro tamaño u otra escala.</translation>
    </message>
</context>
<context>
    <name>slidercrank::FigureForm</name>
    <message>
        <source>Motion of an offset slider-crank</source>
        <translation>Movimiento de un mecanismo biela-manivela descentrado</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>&amp;Values at the current time</source>
        <translation>&amp;Valores en el instante actual</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Unit of the width</source>
        <translation>Unidad del ancho</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Ancho</translation>
    </message>
    <message>
        <source>&amp;Font size</source>
        <translation>Tamaño de &amp;letra</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>F&amp;ormato</translation>
    </message>
    <message>
        <source>Choose a plot.</source>
        <translation>Elija una gráfica.</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
</context>
<context>
    <name>slidercrank::ChannelText</name>
    <message>
        <source>ground</source>
        <translation>bancada</translation>
    </message>
    <message>
        <source>crank</source>
        <translation>manivela</translation>
    </message>
    <message>
        <source>coupler</source>
        <translation>biela</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>corredera</translation>
    </message>
    <message>
        <source>%1 angle</source>
        <translation>ángulo de la %1</translation>
    </message>
    <message>
        <source>%1 angular velocity</source>
        <translation>velocidad angular de la %1</translation>
    </message>
    <message>
        <source>%1 angular acceleration</source>
        <translation>aceleración angular de la %1</translation>
    </message>
    <message>
        <source>%1 position</source>
        <translation>posición de la %1</translation>
    </message>
    <message>
        <source>%1 velocity</source>
        <translation>velocidad de la %1</translation>
    </message>
    <message>
        <source>%1 acceleration</source>
        <translation>aceleración de la %1</translation>
    </message>
    <message>
        <source>%1 centre in x</source>
        <translation>centro de la %1 en x</translation>
    </message>
    <message>
        <source>%1 centre&apos;s velocity in x</source>
        <translation>velocidad en x del centro de la %1</translation>
    </message>
    <message>
        <source>%1 centre&apos;s acceleration in x</source>
        <translation>aceleración en x del centro de la %1</translation>
    </message>
    <message>
        <source>%1 centre in y</source>
        <translation>centro de la %1 en y</translation>
    </message>
    <message>
        <source>%1 centre&apos;s velocity in y</source>
        <translation>velocidad en y del centro de la %1</translation>
    </message>
    <message>
        <source>%1 centre&apos;s acceleration in y</source>
        <translation>aceleración en y del centro de la %1</translation>
    </message>
</context>
<context>
    <name>slidercrank::ComparisonText</name>
    <message>
        <source>differs: nothing to compare with</source>
        <translation>difiere: nada con qué comparar</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>difiere</translation>
    </message>
    <message>
        <source>The file has no column that this program knows.</source>
        <translation>El archivo no tiene ninguna columna que este programa conozca.</translation>
    </message>
    <message>
        <source>agrees within the rounding of the file</source>
        <translation>coincide dentro del redondeo del archivo</translation>
    </message>
    <message>
        <source>close, if the time stamps of the file are rounded</source>
        <translation>casi coincide, si los instantes del archivo están redondeados</translation>
    </message>
    <message>
        <source>Match. Quantities that agree within the rounding of the file: %1 of %2.</source>
        <translation>Coincide. Magnitudes que coinciden dentro del redondeo del archivo: %1 de %2.</translation>
    </message>
    <message>
        <source>Close match. Quantities that agree within the rounding of the file: %1 of %2; the others are close.</source>
        <translation>Coincidencia aproximada. Magnitudes que coinciden dentro del redondeo del archivo: %1 de %2; las demás casi coinciden.</translation>
    </message>
    <message>
        <source>No match: the mechanism cannot be assembled at any time step of the file.</source>
        <translation>No coincide: el mecanismo no se puede ensamblar en ningún instante del archivo.</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>canal</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>error máximo</translation>
    </message>
    <message>
        <source>at θ₂ [%1]</source>
        <translation>en θ₂ [%1]</translation>
    </message>
    <message>
        <source>at t [s]</source>
        <translation>en t [s]</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>% of peak</source>
        <translation>% del máximo</translation>
    </message>
    <message>
        <source>rounding step</source>
        <translation>paso de redondeo</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>veredicto</translation>
    </message>
    <message>
        <source>close: at most %1 times the rounding of the file</source>
        <translation>casi coincide: como máximo %1 veces el redondeo del archivo</translation>
    </message>
    <message>
        <source>max. relative error [%]</source>
        <translation>error relativo máx. [%]</translation>
    </message>
    <message>
        <source>differs; the rounded time stamps may explain it</source>
        <translation>difiere; los instantes redondeados pueden explicarlo</translation>
    </message>
    <message>
        <source>No match. Quantities that differ: %1 of %2.</source>
        <translation>No coincide. Magnitudes que difieren: %1 de %2.</translation>
    </message>
    <message>
        <source>No match. Quantities that differ: %1 of %2, most of all the %3, by %4 % of its peak.</source>
        <translation>No coincide. Magnitudes que difieren: %1 de %2; la mayor diferencia: %3, un %4 % de su máximo.</translation>
    </message>
    <message>
        <source>The rounding of the time stamps is sufficient to explain this: write the file with more digits of the time.</source>
        <translation>El redondeo de los instantes basta para explicarlo: escriba el archivo con más cifras del tiempo.</translation>
    </message>
</context>
<context>
    <name>slidercrank::FindLine</name>
    <message>
        <source>Quantity that has a value</source>
        <translation>Magnitud que tiene un valor</translation>
    </message>
    <message>
        <source>Value of the quantity</source>
        <translation>Valor de la magnitud</translation>
    </message>
    <message>
        <source>Use as ω₂</source>
        <translation>Usar como ω₂</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Turns the crank to the next position in which the quantity has this value</source>
        <translation>Gira la manivela hasta la siguiente posición en la que la magnitud tiene este valor</translation>
    </message>
    <message>
        <source>Sets the crank speed with which the velocity has this value at the present position</source>
        <translation>Fija la velocidad de la manivela con la que la velocidad tiene este valor en la posición actual</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>There is no such position: this θ₃ is measured at B. Choose the angle at A in View &gt; Notation and units.</source>
        <translation>No existe tal posición: este θ₃ se mide en B. Elija el ángulo en A en Ver &gt; Notación y unidades.</translation>
    </message>
    <message>
        <source>There is no such position: this θ³ is measured at A. Choose the angle at B in View &gt; Notation and units.</source>
        <translation>No existe tal posición: este θ³ se mide en A. Elija el ángulo en B en Ver &gt; Notación y unidades.</translation>
    </message>
    <message>
        <source>There is no such position.</source>
        <translation>No existe tal posición.</translation>
    </message>
    <message>
        <source>There is no such position: %1 lies between %2 and %3.</source>
        <translation>No existe tal posición: %1 está entre %2 y %3.</translation>
    </message>
    <message>
        <source>The crank does not reach these positions within the time range.</source>
        <translation>La manivela no alcanza estas posiciones en el intervalo de tiempo.</translation>
    </message>
    <message>
        <source>Positions of a revolution: θ₂ = %1</source>
        <translation>Posiciones de una revolución: θ₂ = %1</translation>
    </message>
    <message>
        <source>No crank speed gives this velocity here: it is 0 at every speed, as at a dead centre.</source>
        <translation>Ninguna velocidad de la manivela da aquí esta velocidad: es 0 a cualquier velocidad, como en un punto muerto.</translation>
    </message>
</context>
<context>
    <name>slidercrank::MyValues</name>
    <message>
        <source>my values</source>
        <translation>mis valores</translation>
    </message>
    <message>
        <source>Type values of your calculation: they are compared with the exact ones, each to its last digit</source>
        <translation>Escriba valores de su cálculo: se comparan con los exactos, cada uno hasta su última cifra</translation>
    </message>
    <message>
        <source>Your values are shown again at %1.</source>
        <translation>Sus valores volverán a mostrarse en %1.</translation>
    </message>
</context>
<context>
    <name>slidercrank::ParameterText</name>
    <message>
        <source>open</source>
        <translation>abierta</translation>
    </message>
    <message>
        <source>crossed</source>
        <translation>cruzada</translation>
    </message>
    <message>
        <source>%1 assembly</source>
        <translation>configuración %1</translation>
    </message>
    <message>
        <source>crank</source>
        <translation>manivela</translation>
    </message>
    <message>
        <source>coupler</source>
        <translation>biela</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fijado</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>excentricidad</translation>
    </message>
    <message>
        <source>crank speed</source>
        <translation>velocidad de la manivela</translation>
    </message>
    <message>
        <source>initial angle</source>
        <translation>ángulo inicial</translation>
    </message>
</context>
<context>
    <name>slidercrank::PolygonText</name>
    <message>
        <source>all vectors are 0</source>
        <translation>todos los vectores son 0</translation>
    </message>
    <message>
        <source>There are no velocities in this position.</source>
        <translation>En esta posición no existen las velocidades.</translation>
    </message>
</context>
<context>
    <name>slidercrank::WordList</name>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
</context>
<context>
    <name>slidercrank::FoldingTabs</name>
    <message>
        <source>Panels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>F9 hides and shows the panels</source>
        <translation>F9 oculta y muestra los paneles</translation>
    </message>
</context>
<context>
    <name>slidercrank::IdentificationText</name>
    <message>
        <source>Mechanism identified in this file: %1.</source>
        <translation>Mecanismo identificado en este archivo: %1.</translation>
    </message>
    <message>
        <source>Mechanism that approximately explains this file: %1.</source>
        <translation>Mecanismo que explica este archivo de forma aproximada: %1.</translation>
    </message>
    <message>
        <source>This file does not determine the mechanism. %1</source>
        <translation>Este archivo no determina el mecanismo. %1</translation>
    </message>
    <message>
        <source>No mechanism explains this file. %1</source>
        <translation>Ningún mecanismo explica este archivo. %1</translation>
    </message>
    <message>
        <source>It contains too few values: export more time steps or more columns.</source>
        <translation>Contiene muy pocos valores: exporte más instantes o más columnas.</translation>
    </message>
    <message>
        <source>In no column that was read does the slider or the coupler move: name the column of the slider&apos;s position or of the coupler&apos;s angle, or export one while the crank turns.</source>
        <translation>En ninguna columna leída se mueve la corredera o la biela: indique la columna de la posición de la corredera o del ángulo de la biela, o exporte una mientras gira la manivela.</translation>
    </message>
    <message>
        <source>It has fewer than four rows per revolution, so that several crank speeds give the same values: more rows per revolution, derivatives or θ₂ would help.</source>
        <translation>Tiene menos de cuatro filas por revolución, de modo que varias velocidades de la manivela dan los mismos valores: ayudarían más filas por revolución, las derivadas o θ₂.</translation>
    </message>
    <message>
        <source>The crank speed varies, so that derivatives alone do not show the mechanism: positions of the slider or angles of the coupler would help.</source>
        <translation>La velocidad de la manivela varía, de modo que las derivadas por sí solas no muestran el mecanismo: ayudarían las posiciones de la corredera o los ángulos de la biela.</translation>
    </message>
    <message>
        <source>Open: %1. A longer part of a revolution, derivatives, θ₂ or more digits would help.</source>
        <translation>Sin determinar: %1. Ayudarían una parte mayor de la revolución, las derivadas, θ₂ o más cifras.</translation>
    </message>
    <message>
        <source>The best attempt deviates by up to %1 % of the range of %2: check the meaning and the units of the columns. Unless the crank speed is constant, the file must contain θ₂.</source>
        <translation>El mejor intento se desvía hasta un %1 % del intervalo de valores de %2: compruebe el significado y las unidades de las columnas. Si la velocidad de la manivela no es constante, el archivo debe contener θ₂.</translation>
    </message>
    <message>
        <source>R4_y is not constant: the slider does not move parallel to the x axis.</source>
        <translation>R4_y no es constante: la corredera no se mueve en paralelo al eje x.</translation>
    </message>
    <message>
        <source>The mechanisms that come near cannot be assembled in all of its rows: check the meaning and the units of the columns.</source>
        <translation>Los mecanismos que se aproximan no se pueden ensamblar en todas sus filas: compruebe el significado y las unidades de las columnas.</translation>
    </message>
    <message>
        <source>Check the meaning and the units of the columns.</source>
        <translation>Compruebe el significado y las unidades de las columnas.</translation>
    </message>
    <message>
        <source>Its mirror image, with c, ω₂ and θ₂₀ negated, gives the same values.</source>
        <translation>Su imagen especular, con c, ω₂ y θ₂₀ de signo contrario, da los mismos valores.</translation>
    </message>
    <message>
        <source>A crank that rotates in the opposite direction, from 180° − θ₂₀, gives the same values.</source>
        <translation>Una manivela que gira en sentido contrario, desde 180° − θ₂₀, da los mismos valores.</translation>
    </message>
    <message>
        <source>The other assembly, with c negated and θ₂₀ increased by 180°, gives the same values.</source>
        <translation>La otra configuración, con c de signo contrario y θ₂₀ aumentado en 180°, da los mismos valores.</translation>
    </message>
    <message>
        <source>agrees with finite differences, not with the derivative</source>
        <translation>coincide con las diferencias finitas, no con la derivada</translation>
    </message>
    <message>
        <source>the crank speed is not constant</source>
        <translation>la velocidad de la manivela no es constante</translation>
    </message>
    <message>
        <source>the crank speed is unknown</source>
        <translation>no se conoce la velocidad de la manivela</translation>
    </message>
    <message>
        <source>the motion of a different mechanism</source>
        <translation>el movimiento de un mecanismo distinto</translation>
    </message>
    <message>
        <source>does not fit the other columns</source>
        <translation>no coincide con las demás columnas</translation>
    </message>
    <message>
        <source>%1 at t = 0</source>
        <translation>%1 en t = 0</translation>
    </message>
    <message>
        <source>%1 on average</source>
        <translation>%1 en promedio</translation>
    </message>
    <message>
        <source>The columns deviate from its motion by up to %1 % of the range of %2. The residuals are systematic, so that no standard errors can be given: the data may be filtered, interpolated or integrated, or the crank speed may vary.</source>
        <translation>Las columnas se desvían de su movimiento hasta un %1 % del intervalo de valores de %2. Los residuos son sistemáticos, por lo que no se pueden dar errores estándar: los datos pueden estar filtrados, interpolados o integrados, o la velocidad de la manivela puede variar.</translation>
    </message>
    <message>
        <source>The columns agree with the approximate formula Rₓ⁴ ≈ a cos θ₂ + b − (a sin θ₂ − c)²/2b. From the exact motion they deviate by up to %1 % of the range of %2.</source>
        <translation>Las columnas concuerdan con la fórmula aproximada Rₓ⁴ ≈ a cos θ₂ + b − (a sen θ₂ − c)²/2b. Del movimiento exacto se desvían hasta un %1 % del intervalo de valores de %2.</translation>
    </message>
    <message>
        <source>The columns deviate from its motion by up to %1 % of the range of %2, more than by rounding; ± holds if these errors are independent.</source>
        <translation>Las columnas se desvían de su movimiento hasta un %1 % del intervalo de valores de %2, más de lo que explica el redondeo; ± es válido si estos errores son independientes.</translation>
    </message>
    <message>
        <source>The data do not determine %1. Kept as given: %2.</source>
        <translation>Los datos no determinan %1. Se conserva el valor dado: %2.</translation>
    </message>
    <message>
        <source>The derivatives allow ω₂ = %1 rad/s, because their unit is uncertain (radians or degrees, mm or cm?): state it in the headings.</source>
        <translation>Las derivadas admiten ω₂ = %1 rad/s, porque su unidad es dudosa (¿radianes o grados, mm o cm?): indíquela en los encabezados.</translation>
    </message>
    <message>
        <source>Outliers that were excluded: %1 (lines %2).</source>
        <translation>Valores atípicos excluidos: %1 (líneas %2).</translation>
    </message>
    <message>
        <source>Line %1 is far from the motion: a typing error?</source>
        <translation>La línea %1 está lejos del movimiento: ¿un error de escritura?</translation>
    </message>
    <message>
        <source>Lines %1 are far from the motion: typing errors?</source>
        <translation>Las líneas %1 están lejos del movimiento: ¿errores de escritura?</translation>
    </message>
    <message>
        <source>it has gaps, or its rows are too far apart</source>
        <translation>tiene huecos, o sus filas están demasiado separadas</translation>
    </message>
    <message>
        <source>The coupler angle θ³ alone determines only b/a and c/a.</source>
        <translation>El ángulo de la biela θ³ por sí solo determina únicamente b/a y c/a.</translation>
    </message>
    <message>
        <source>Derivatives over the crank angle determine only b/a, c/a and the product a·ω₂: the lengths hold for the given ω₂.</source>
        <translation>Las derivadas en función del ángulo de la manivela determinan únicamente b/a, c/a y el producto a·ω₂: las longitudes valen para la ω₂ dada.</translation>
    </message>
    <message>
        <source>It determines %1.</source>
        <translation>Determina %1.</translation>
    </message>
    <message>
        <source>The search was stopped.</source>
        <translation>La búsqueda se detuvo.</translation>
    </message>
    <message>
        <source>Rounded values that fit equally well: %1.</source>
        <translation>Valores redondeados que se ajustan igual de bien: %1.</translation>
    </message>
    <message>
        <source>The crank speed of the file is not constant.</source>
        <translation>La velocidad de la manivela del archivo no es constante.</translation>
    </message>
    <message>
        <source>With %1 instead of %2, this mechanism agrees with the file.</source>
        <translation>Con %1 en lugar de %2, este mecanismo coincide con el archivo.</translation>
    </message>
    <message>
        <source>With %1 instead of %2, this mechanism fits the file as well as any other.</source>
        <translation>Con %1 en lugar de %2, este mecanismo se ajusta al archivo tan bien como cualquier otro.</translation>
    </message>
    <message>
        <source>%1 (%2; off by up to %3 % of its peak)</source>
        <translation>%1 (%2; se desvía hasta un %3 % de su máximo)</translation>
    </message>
    <message>
        <source>Columns left out of the fit: %1.</source>
        <translation>Columnas excluidas del ajuste: %1.</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>canal</translation>
    </message>
    <message>
        <source>rms residual</source>
        <translation>residuo RMS</translation>
    </message>
    <message>
        <source>largest residual</source>
        <translation>residuo máximo</translation>
    </message>
    <message>
        <source>% of range</source>
        <translation>% del intervalo</translation>
    </message>
    <message>
        <source>The crank speed varies from %1 to %2 rad/s</source>
        <translation>La velocidad de la manivela varía de %1 a %2 rad/s</translation>
    </message>
    <message>
        <source>%1; it changes evenly, α₂ = %2 rad/s².</source>
        <translation>%1; cambia uniformemente, α₂ = %2 rad/s².</translation>
    </message>
    <message>
        <source>%1 The window shows the motion at the mean speed, %2 rad/s, because a changing speed is not modelled: compare the positions over the crank angle.</source>
        <translation>%1 La ventana muestra el movimiento a la velocidad media, %2 rad/s, porque no se modela una velocidad variable: compare las posiciones en función del ángulo de la manivela.</translation>
    </message>
</context>
<context>
    <name>slidercrank::LimitsPage</name>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>Crank angle, 0 to 360°</source>
        <translation>Ángulo de la manivela, de 0 a 360°</translation>
    </message>
    <message>
        <source>t [s]</source>
        <translation>t [s]</translation>
    </message>
    <message>
        <source>First time at which the crank is there</source>
        <translation>Primer instante en que la manivela está allí</translation>
    </message>
    <message>
        <source>Click or press Enter to go there</source>
        <translation>Haga clic o pulse Intro para ir allí</translation>
    </message>
    <message>
        <source>Outside the simulated time range</source>
        <translation>Fuera del intervalo de tiempo simulado</translation>
    </message>
    <message>
        <source>Limits of the motion</source>
        <translation>Límites del movimiento</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>límite</translation>
    </message>
    <message>
        <source>Where slider and crank reverse, the stroke times, and the largest velocities and accelerations over a whole revolution of the crank, whatever part of it is simulated</source>
        <translation>Dónde se invierten la corredera y la manivela, los tiempos de las carreras, y las mayores velocidades y aceleraciones en una revolución completa de la manivela, sea cual sea la parte simulada</translation>
    </message>
    <message>
        <source>Positions are those of the slider, measured from O₂; x points to the right, angles are counter-clockwise</source>
        <translation>Las posiciones son las de la corredera, medidas desde O₂; x apunta a la derecha, los ángulos son antihorarios</translation>
    </message>
</context>
<context>
    <name>slidercrank::MainWindow</name>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>Newton-Raphson</source>
        <translation>Newton-Raphson</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Velocidad y exactitud</translation>
    </message>
    <message>
        <source>Motion limits</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Slider-crank[*]</source>
        <translation>Biela-manivela[*]</translation>
    </message>
    <message>
        <source>%1[*] – Slider-crank</source>
        <translation>%1[*] – Biela-manivela</translation>
    </message>
    <message>
        <source>Errors against the reference</source>
        <translation>Errores frente a la referencia</translation>
    </message>
    <message>
        <source>%1 is a scene: open it alone, and the files of one motion together.</source>
        <translation>%1 es una escena: ábrala sola, y juntos los archivos de un mismo movimiento.</translation>
    </message>
    <message>
        <source>A file is still being written. Close the window when it is done, or cancel it below.</source>
        <translation>Todavía se está escribiendo un archivo. Cierre la ventana cuando termine, o cancélelo abajo.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Respuesta</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Diseño</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>Ecuaciones</translation>
    </message>
    <message>
        <source>Jacobian</source>
        <translation>Jacobiano</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteraciones</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordenadas</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Scenes and simulation results (*.slidercrank *.json *.csv *.txt *.tsv *.tab *.dat *.dta *.mot);;All files (*)</source>
        <translation>Escenas y resultados de simulación (*.slidercrank *.json *.csv *.txt *.tsv *.tab *.dat *.dta *.mot);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>Polígonos</translation>
    </message>
</context>
<context>
    <name>slidercrank::MechanismSketch</name>
    <message>
        <source>file</source>
        <translation>archivo</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fijado</translation>
    </message>
    <message>
        <source>no velocity: the coupler is perpendicular to the slider&apos;s line</source>
        <translation>sin velocidad: la biela es perpendicular a la línea de la corredera</translation>
    </message>
    <message>
        <source>outer dead centre</source>
        <translation>punto muerto exterior</translation>
    </message>
    <message>
        <source>inner dead centre</source>
        <translation>punto muerto interior</translation>
    </message>
    <message>
        <source>outer</source>
        <comment>dead centre</comment>
        <translation>exterior</translation>
    </message>
    <message>
        <source>Instant centre P at infinity:
the coupler translates at %1</source>
        <translation>Centro instantáneo P en el infinito:
la biela se traslada a %1</translation>
    </message>
    <message>
        <source>Instant centre P: %1 = %2 rad/s = %3 °/s
PA = %4, PB = %5</source>
        <translation>Centro instantáneo P: %1 = %2 rad/s = %3 °/s
PA = %4, PB = %5</translation>
    </message>
    <message>
        <source>gap = %1</source>
        <translation>separación = %1</translation>
    </message>
    <message>
        <source>inner</source>
        <comment>dead centre</comment>
        <translation>interior</translation>
    </message>
</context>
<context>
    <name>slidercrank::MechanismText</name>
    <message>
        <source>no velocity: the coupler is perpendicular to the slider&apos;s line</source>
        <translation>sin velocidad: la biela es perpendicular a la línea de la corredera</translation>
    </message>
    <message>
        <source>%1: the slider reverses. Click to go there.</source>
        <translation>%1: la corredera invierte su movimiento. Haga clic para ir allí.</translation>
    </message>
    <message>
        <source>O₂, the fixed pivot of the crank</source>
        <translation>O₂, el pivote fijo de la manivela</translation>
    </message>
    <message>
        <source>A: drag to move the mechanism, with Shift to change a.</source>
        <translation>A: arrastre para mover el mecanismo; con Mayús, para cambiar a.</translation>
    </message>
    <message>
        <source>B: drag to move the mechanism.</source>
        <translation>B: arrastre para mover el mecanismo.</translation>
    </message>
    <message>
        <source>G₃, the coupler&apos;s centre of mass</source>
        <translation>G₃, el centro de masa de la biela</translation>
    </message>
    <message>
        <source>Crank, %1: drag to change a.</source>
        <translation>Manivela, %1: arrastre para cambiar a.</translation>
    </message>
    <message>
        <source>Coupler, %1: drag to change b.</source>
        <translation>Biela, %1: arrastre para cambiar b.</translation>
    </message>
    <message>
        <source>The slider&apos;s line, %1: drag up or down to change c.</source>
        <translation>La línea de la corredera, %1: arrastre hacia arriba o abajo para cambiar c.</translation>
    </message>
    <message>
        <source>Outer dead centre</source>
        <translation>Punto muerto exterior</translation>
    </message>
    <message>
        <source>Inner dead centre</source>
        <translation>Punto muerto interior</translation>
    </message>
    <message>
        <source>The crank angle at this time is not a finite number.</source>
        <translation>El ángulo de la manivela en este instante no es un número finito.</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>en reposo</translation>
    </message>
    <message>
        <source>position (%1; %2) %3</source>
        <translation>posición (%1; %2) %3</translation>
    </message>
    <message>
        <source>velocity %1 %2 (%3; %4)</source>
        <translation>velocidad %1 %2 (%3; %4)</translation>
    </message>
    <message>
        <source>acceleration %1 %2 (%3; %4)</source>
        <translation>aceleración %1 %2 (%3; %4)</translation>
    </message>
    <message>
        <source>slider at %1</source>
        <translation>corredera en %1</translation>
    </message>
    <message>
        <source>Scale: %1 = %2</source>
        <translation>Escala: %1 = %2</translation>
    </message>
    <message>
        <source>The mechanism cannot be assembled at any crank angle: the coupler does not reach the slider&apos;s line. It can be assembled if b ≥ %1; the crank makes full turns if b ≥ %2.</source>
        <translation>El mecanismo no se puede ensamblar en ningún ángulo de la manivela: la biela no alcanza la línea de la corredera. Se puede ensamblar si b ≥ %1; la manivela da vueltas completas si b ≥ %2.</translation>
    </message>
    <message>
        <source>The mechanism cannot be assembled at θ₂ = %1: the coupler is too short. The crank makes full turns if b ≥ %2.</source>
        <translation>El mecanismo no se puede ensamblar en θ₂ = %1: la biela es demasiado corta. La manivela da vueltas completas si b ≥ %2.</translation>
    </message>
</context>
<context>
    <name>slidercrank::MechanismView</name>
    <message>
        <source>Mechanism</source>
        <translation>Mecanismo</translation>
    </message>
    <message>
        <source>&amp;Velocity arrows</source>
        <translation>Flechas de &amp;velocidad</translation>
    </message>
    <message>
        <source>&amp;Acceleration arrows</source>
        <translation>Flechas de &amp;aceleración</translation>
    </message>
    <message>
        <source>&amp;Path of the coupler&apos;s centre</source>
        <translation>&amp;Trayectoria del centro de la biela</translation>
    </message>
    <message>
        <source>&amp;Names of the points</source>
        <translation>&amp;Nombres de los puntos</translation>
    </message>
    <message>
        <source>&amp;Dimensions</source>
        <translation>&amp;Cotas</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>A&amp;mpliar</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Reducir</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;justar</translation>
    </message>
    <message>
        <source>An&amp;gles of crank and coupler</source>
        <translation>Án&amp;gulos de la manivela y la biela</translation>
    </message>
    <message>
        <source>Instant &amp;centre of the coupler</source>
        <translation>Centro &amp;instantáneo de la biela</translation>
    </message>
    <message>
        <source>Assembly: open</source>
        <translation>Configuración: abierta</translation>
    </message>
    <message>
        <source>Assembly: crossed</source>
        <translation>Configuración: cruzada</translation>
    </message>
    <message>
        <source>Flip to the crossed assembly: the same links, with B to the left of A</source>
        <translation>Pasar a la configuración cruzada: los mismos eslabones, con B a la izquierda de A</translation>
    </message>
    <message>
        <source>Flip to the open assembly: the same links, with B to the right of A</source>
        <translation>Pasar a la configuración abierta: los mismos eslabones, con B a la derecha de A</translation>
    </message>
    <message>
        <source>Slider-crank drawn to scale: crank %1, coupler %2, offset %3. The keys of the Playback menu move it, the sliders and boxes below change its lengths. Plus, minus and 0 zoom, Control with the arrows moves the drawing, Page Down and Page Up describe its parts one after the other.</source>
        <translation>Mecanismo biela-manivela dibujado a escala: manivela %1, biela %2, excentricidad %3. Las teclas del menú Reproducción lo mueven; los controles deslizantes y las casillas de abajo cambian sus longitudes. Más, menos y 0 cambian el zoom, Control con las flechas mueve el dibujo, y Av Pág y Re Pág describen sus partes una tras otra.</translation>
    </message>
</context>
<context>
    <name>slidercrank::Menus</name>
    <message>
        <source>A file is still being read or written. Choose the language again when it is done; otherwise it changes when the program is next started.</source>
        <translation>Todavía se está leyendo o escribiendo un archivo. Elija de nuevo el idioma cuando termine; de lo contrario, cambiará en el próximo inicio.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>Open the samp&amp;le</source>
        <translation>Abrir el e&amp;jemplo</translation>
    </message>
    <message>
        <source>&amp;Close reference</source>
        <translation>C&amp;errar referencia</translation>
    </message>
    <message>
        <source>&amp;Save scene</source>
        <translation>&amp;Guardar escena</translation>
    </message>
    <message>
        <source>Save scene &amp;as…</source>
        <translation>G&amp;uardar escena como…</translation>
    </message>
    <message>
        <source>Copy lin&amp;k</source>
        <translation>Copiar en&amp;lace</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportar</translation>
    </message>
    <message>
        <source>&amp;Figure…</source>
        <translation>&amp;Figura…</translation>
    </message>
    <message>
        <source>&amp;Mechanism…</source>
        <translation>&amp;Mecanismo…</translation>
    </message>
    <message>
        <source>&amp;Data…</source>
        <translation>&amp;Datos…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Informe…</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>&amp;Animación…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>No file yet</source>
        <translation>Todavía ninguno</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Copy figure</source>
        <translation>&amp;Copiar la figura</translation>
    </message>
    <message>
        <source>Copy &amp;mechanism</source>
        <translation>Copiar el &amp;mecanismo</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>M&amp;echanism</source>
        <translation>M&amp;ecanismo</translation>
    </message>
    <message>
        <source>Pl&amp;ots</source>
        <translation>&amp;Gráficas</translation>
    </message>
    <message>
        <source>Show the &amp;panels below</source>
        <translation>Mostrar los &amp;paneles de abajo</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>&amp;System colours</source>
        <translation>Colores del &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>Del &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>&amp;Reproducción</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>Teclado y &amp;ratón</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Teclado y ratón</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;Acerca de</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Acerca de</translation>
    </message>
    <message>
        <source>&lt;h3&gt;slidercrank %1&lt;/h3&gt;&lt;p&gt;The motion of an offset slider-crank: computed, shown, and compared with a simulation.&lt;/p&gt;&lt;p&gt;Formulation after A. A. Shabana, &lt;i&gt;Computational Dynamics&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;slidercrank %1&lt;/h3&gt;&lt;p&gt;El movimiento de un mecanismo biela-manivela descentrado: calculado, mostrado y comparado con una simulación.&lt;/p&gt;&lt;p&gt;Formulación según A. A. Shabana, &lt;i&gt;Computational Dynamics&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Rese&amp;t all parameters</source>
        <translation>Restablecer todos los &amp;parámetros</translation>
    </message>
    <message>
        <source>%1 + %2 more</source>
        <translation>%1 + %2 más</translation>
    </message>
    <message>
        <source>&amp;Reset plot zoom</source>
        <translation>Resta&amp;blecer el zoom de las gráficas</translation>
    </message>
    <message>
        <source>&amp;Theory and help</source>
        <translation>&amp;Teoría y ayuda</translation>
    </message>
    <message>
        <source>Theory and help</source>
        <translation>Teoría y ayuda</translation>
    </message>
    <message>
        <source>P&amp;in this motion</source>
        <translation>F&amp;ijar este movimiento</translation>
    </message>
    <message>
        <source>Remo&amp;ve pinned motions</source>
        <translation>&amp;Quitar los movimientos fijados</translation>
    </message>
    <message>
        <source>Show the mo&amp;tion of the file or the pinned one</source>
        <translation>Mostrar el &amp;movimiento del archivo o el fijado</translation>
    </message>
    <message>
        <source>Presentation &amp;mode</source>
        <translation>Modo p&amp;resentación</translation>
    </message>
    <message>
        <source>qrc:/help/english.html</source>
        <comment>a resource of the program</comment>
        <translation>qrc:/help/spanish.html</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>&amp;Notation and units</source>
        <translation>&amp;Notación y unidades</translation>
    </message>
    <message>
        <source>&amp;Absolute coordinates (θ³ measured at A)</source>
        <translation>Coordenadas &amp;absolutas (θ³ medido en A)</translation>
    </message>
    <message>
        <source>&amp;Textbook (θ₃ measured at B)</source>
        <translation>Libro de &amp;texto (θ₃ medido en B)</translation>
    </message>
    <message>
        <source>&amp;Degrees</source>
        <translation>&amp;Grados</translation>
    </message>
    <message>
        <source>&amp;Radians</source>
        <translation>&amp;Radianes</translation>
    </message>
    <message>
        <source>Degrees, with rad/&amp;s and rad/s²</source>
        <translation>Grados, con rad/&amp;s y rad/s²</translation>
    </message>
    <message>
        <source>&amp;mm</source>
        <translation>&amp;mm</translation>
    </message>
    <message>
        <source>&amp;cm</source>
        <translation>&amp;cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>&amp;in</source>
        <translation>p&amp;ulgadas</translation>
    </message>
    <message>
        <source>&amp;Polygons…</source>
        <translation>&amp;Polígonos…</translation>
    </message>
</context>
<context>
    <name>slidercrank::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>slidercrank::Messages</name>
    <message>
        <source>The scene is open without its reference. %1</source>
        <translation>La escena está abierta sin su referencia. %1</translation>
    </message>
    <message>
        <source>Choose columns…</source>
        <translation>Elegir columnas…</translation>
    </message>
    <message>
        <source>The headings in %1 do not identify every column: some meanings were guessed.</source>
        <translation>Los encabezados de %1 no identifican todas las columnas: algunos significados se han deducido.</translation>
    </message>
    <message>
        <source>Open reference…</source>
        <translation>Abrir referencia…</translation>
    </message>
</context>
<context>
    <name>slidercrank::MotionFacts</name>
    <message>
        <source>throughout</source>
        <translation>siempre</translation>
    </message>
    <message>
        <source>crank at rest</source>
        <translation>manivela en reposo</translation>
    </message>
    <message>
        <source>Largest value over one revolution of the crank, where its derivative is zero</source>
        <translation>El mayor valor en una revolución de la manivela, donde su derivada es cero</translation>
    </message>
    <message>
        <source>%1 in total, at most %2 at a time step</source>
        <translation>%1 en total, a lo sumo %2 en un paso de tiempo</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>límite</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>Unbounded where the coupler is perpendicular to the slider&apos;s line</source>
        <translation>No acotado donde la biela es perpendicular a la línea de la corredera</translation>
    </message>
    <message>
        <source>The crank can make full turns: b = %1 ≥ a + |c| = %2.</source>
        <translation>La manivela puede dar vueltas completas: b = %1 ≥ a + |c| = %2.</translation>
    </message>
    <message>
        <source>Where the coupler is perpendicular to the slider&apos;s line, the velocities jump.</source>
        <translation>Donde la biela es perpendicular a la línea de la corredera, las velocidades dan un salto.</translation>
    </message>
    <message>
        <source>The crank oscillates within one of two arcs and cannot make a full turn: b = %1 &lt; a + |c| = %2, and also less than a − |c| = %3.</source>
        <translation>La manivela oscila dentro de uno de dos arcos y no puede dar una vuelta completa: b = %1 &lt; a + |c| = %2, y también menor que a − |c| = %3.</translation>
    </message>
    <message>
        <source>The crank oscillates and cannot make a full turn: b = %1 &lt; a + |c| = %2.</source>
        <translation>La manivela oscila y no puede dar una vuelta completa: b = %1 &lt; a + |c| = %2.</translation>
    </message>
    <message>
        <source>The crank oscillates and cannot make a full turn: b is less than a + |c| = %1, by less than the last digit shown.</source>
        <translation>La manivela oscila y no puede dar una vuelta completa: b es menor que a + |c| = %1, por menos de la última cifra mostrada.</translation>
    </message>
    <message>
        <source>The crank is locked in a single position: b = |c| − a = %1. It makes full turns if b ≥ a + |c| = %2.</source>
        <translation>La manivela está bloqueada en una única posición: b = |c| − a = %1. Da vueltas completas si b ≥ a + |c| = %2.</translation>
    </message>
    <message>
        <source>%1 samples per revolution are too few for a curve: at least %2 are needed.</source>
        <translation>%1 muestras por revolución son muy pocas para una curva: se necesitan al menos %2.</translation>
    </message>
    <message>
        <source>The mechanism cannot be assembled: b = %1 &lt; |c| − a = %2. The crank makes full turns if b ≥ a + |c| = %3.</source>
        <translation>El mecanismo no se puede ensamblar: b = %1 &lt; |c| − a = %2. La manivela da vueltas completas si b ≥ a + |c| = %3.</translation>
    </message>
    <message>
        <source>peak %1</source>
        <comment>of a velocity or an acceleration</comment>
        <translation>pico de %1</translation>
    </message>
    <message>
        <source>outer dead centre</source>
        <translation>punto muerto exterior</translation>
    </message>
    <message>
        <source>Slider position at which the slider reverses, crank and coupler extended in one line</source>
        <translation>Posición de la corredera en la que esta invierte su sentido, con manivela y biela alineadas y extendidas</translation>
    </message>
    <message>
        <source>inner dead centre</source>
        <translation>punto muerto interior</translation>
    </message>
    <message>
        <source>Slider position at which the slider reverses, crank and coupler overlapping in one line</source>
        <translation>Posición de la corredera en la que esta invierte su sentido, con manivela y biela alineadas y superpuestas</translation>
    </message>
    <message>
        <source>crank limit position</source>
        <translation>posición límite de la manivela</translation>
    </message>
    <message>
        <source>The crank can go no further: the coupler is perpendicular to the slider&apos;s line. The value is the slider position.</source>
        <translation>La manivela no puede avanzar más: la biela es perpendicular a la línea de la corredera. El valor es la posición de la corredera.</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>carrera</translation>
    </message>
    <message>
        <source>Travel of the slider: its largest position minus its smallest</source>
        <translation>Recorrido de la corredera: su posición máxima menos la mínima</translation>
    </message>
    <message>
        <source>crank angle, forward stroke</source>
        <translation>giro de la manivela, carrera de ida</translation>
    </message>
    <message>
        <source>Crank rotation from the inner to the outer dead centre</source>
        <translation>Giro de la manivela del punto muerto interior al exterior</translation>
    </message>
    <message>
        <source>time, forward stroke</source>
        <translation>tiempo, carrera de ida</translation>
    </message>
    <message>
        <source>Time from the inner to the outer dead centre: the crank rotation divided by |ω₂|</source>
        <translation>Tiempo del punto muerto interior al exterior: el giro de la manivela dividido por |ω₂|</translation>
    </message>
    <message>
        <source>mean speed, forward stroke</source>
        <translation>velocidad media, carrera de ida</translation>
    </message>
    <message>
        <source>The stroke divided by the time of the forward stroke</source>
        <translation>La carrera dividida por el tiempo de la carrera de ida</translation>
    </message>
    <message>
        <source>crank angle, return stroke</source>
        <translation>giro de la manivela, carrera de retorno</translation>
    </message>
    <message>
        <source>Crank rotation from the outer to the inner dead centre</source>
        <translation>Giro de la manivela del punto muerto exterior al interior</translation>
    </message>
    <message>
        <source>time, return stroke</source>
        <translation>tiempo, carrera de retorno</translation>
    </message>
    <message>
        <source>Time from the outer to the inner dead centre: the crank rotation divided by |ω₂|</source>
        <translation>Tiempo del punto muerto exterior al interior: el giro de la manivela dividido por |ω₂|</translation>
    </message>
    <message>
        <source>mean speed, return stroke</source>
        <translation>velocidad media, carrera de retorno</translation>
    </message>
    <message>
        <source>The stroke divided by the time of the return stroke</source>
        <translation>La carrera dividida por el tiempo de la carrera de retorno</translation>
    </message>
    <message>
        <source>time ratio</source>
        <translation>relación de tiempos</translation>
    </message>
    <message>
        <source>Time of the slower stroke divided by the time of the faster one</source>
        <translation>El tiempo de la carrera más lenta dividido por el de la más rápida</translation>
    </message>
    <message>
        <source>minimum transmission angle</source>
        <translation>ángulo de transmisión mínimo</translation>
    </message>
    <message>
        <source>The transmission angle μ is the acute angle between the coupler and the normal to the slider&apos;s line. Mechanisms with a minimum of less than about 40° tend to jam.</source>
        <translation>El ángulo de transmisión μ es el ángulo agudo entre la biela y la normal a la línea de la corredera. Los mecanismos con un mínimo menor de unos 40° tienden a atascarse.</translation>
    </message>
    <message>
        <source>maximum transmission angle</source>
        <translation>ángulo de transmisión máximo</translation>
    </message>
    <message>
        <source>90° where the coupler is parallel to the slider&apos;s line</source>
        <translation>90° donde la biela es paralela a la línea de la corredera</translation>
    </message>
    <message>
        <source>minimum coupler angle</source>
        <translation>ángulo mínimo de la biela</translation>
    </message>
    <message>
        <source>Smallest angle of the coupler over a revolution of the crank</source>
        <translation>Menor ángulo de la biela en una revolución de la manivela</translation>
    </message>
    <message>
        <source>maximum coupler angle</source>
        <translation>ángulo máximo de la biela</translation>
    </message>
    <message>
        <source>Largest angle of the coupler over a revolution of the crank</source>
        <translation>Mayor ángulo de la biela en una revolución de la manivela</translation>
    </message>
    <message>
        <source>swing of the coupler</source>
        <translation>oscilación de la biela</translation>
    </message>
    <message>
        <source>The largest angle of the coupler minus its smallest</source>
        <translation>El mayor ángulo de la biela menos el menor</translation>
    </message>
    <message>
        <source>Here the coupler is perpendicular to the slider&apos;s line, and the velocities jump: just before and just after this position, velocities and accelerations are different.</source>
        <translation>Aquí la biela es perpendicular a la línea de la corredera y las velocidades dan un salto: justo antes y justo después de esta posición, las velocidades y aceleraciones son distintas.</translation>
    </message>
    <message>
        <source>The coupler is perpendicular to the slider&apos;s line: the position exists, velocity and acceleration do not, because the Jacobian is singular.</source>
        <translation>La biela es perpendicular a la línea de la corredera: la posición existe; la velocidad y la aceleración, no, porque el jacobiano es singular.</translation>
    </message>
    <message numerus="yes">
        <source>Newton-Raphson did not converge within %n iterations: allow more iterations or a larger tolerance.</source>
        <translation>
            <numerusform>Newton-Raphson no convergió en %n iteración: permita más iteraciones o una tolerancia mayor.</numerusform>
            <numerusform>Newton-Raphson no convergió en %n iteraciones: permita más iteraciones o una tolerancia mayor.</numerusform>
        </translation>
    </message>
    <message>
        <source>The mechanism cannot be assembled: the coupler is too short.</source>
        <translation>El mecanismo no se puede ensamblar: la biela es demasiado corta.</translation>
    </message>
    <message>
        <source>The crank angle is too large for Newton-Raphson, which stores θ₂ with 16 digits: choose the closed form, a smaller ω₂, or times nearer to 0.</source>
        <translation>El ángulo de la manivela es demasiado grande para Newton-Raphson, que guarda θ₂ con 16 cifras: elija la forma cerrada, una ω₂ menor o instantes más cercanos a 0.</translation>
    </message>
</context>
<context>
    <name>slidercrank::MotionTable</name>
    <message>
        <source>Time; a dash where the crank does not reach this angle within the time range</source>
        <translation>Tiempo; una raya donde la manivela no alcanza este ángulo en el intervalo de tiempo</translation>
    </message>
    <message>
        <source>Crank angle</source>
        <translation>Ángulo de la manivela</translation>
    </message>
</context>
<context>
    <name>slidercrank::MotionTablePanel</name>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>Chooses the columns of the table</source>
        <translation>Elige las columnas de la tabla</translation>
    </message>
    <message>
        <source>Table of the motion</source>
        <translation>Tabla del movimiento</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>Cada</translation>
    </message>
    <message>
        <source>Step of the table</source>
        <translation>Paso de la tabla</translation>
    </message>
    <message>
        <source>Unit of the step</source>
        <translation>Unidad del paso</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>α₂</source>
        <translation>α₂</translation>
    </message>
    <message>
        <source>Acceleration of the crank in each row (α₂)</source>
        <translation>Aceleración de la manivela en cada fila (α₂)</translation>
    </message>
    <message>
        <source>Acceleration of the crank in each row of the table. The curves are for a constant speed.</source>
        <translation>Aceleración de la manivela en cada fila de la tabla. Las curvas son para una velocidad constante.</translation>
    </message>
    <message>
        <source> rad/s²</source>
        <translation> rad/s²</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copies the rows as CSV</source>
        <translation>Copia las filas como CSV</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Writes the rows to a CSV file</source>
        <translation>Escribe las filas en un archivo CSV</translation>
    </message>
    <message>
        <source>Write to a file…</source>
        <translation>Escribir en un archivo…</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabla</translation>
    </message>
    <message>
        <source>All digits instead of six</source>
        <translation>Todas las cifras en lugar de seis</translation>
    </message>
    <message>
        <source>Decimal sign and delimiter of the language</source>
        <translation>Signo decimal y separador del idioma</translation>
    </message>
    <message>
        <source>Present position</source>
        <translation>Posición actual</translation>
    </message>
    <message>
        <source>The rows are in the clipboard, as CSV with headings.</source>
        <translation>Las filas están en el portapapeles, como CSV con encabezados.</translation>
    </message>
    <message>
        <source>θ₃ measured at B, and x&lt;sub&gt;B&lt;/sub&gt;, v&lt;sub&gt;B&lt;/sub&gt;, a&lt;sub&gt;B&lt;/sub&gt;, as in textbooks?</source>
        <translation>¿θ₃ medido en B, y x&lt;sub&gt;B&lt;/sub&gt;, v&lt;sub&gt;B&lt;/sub&gt;, a&lt;sub&gt;B&lt;/sub&gt;, como en los libros de texto?</translation>
    </message>
    <message>
        <source>Use this notation</source>
        <translation>Usar esta notación</translation>
    </message>
    <message>
        <source>Keep θ³, Rₓ⁴</source>
        <translation>Conservar θ³, Rₓ⁴</translation>
    </message>
    <message>
        <source>The curves are for a constant speed.</source>
        <translation>Las curvas son para velocidad constante.</translation>
    </message>
</context>
<context>
    <name>slidercrank::NativeDialogText</name>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
</context>
<context>
    <name>slidercrank::PageDialogText</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
</context>
<context>
    <name>slidercrank::NewtonPages</name>
    <message>
        <source>ground</source>
        <translation>bancada</translation>
    </message>
    <message>
        <source>crank</source>
        <translation>manivela</translation>
    </message>
    <message>
        <source>coupler</source>
        <translation>biela</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>corredera</translation>
    </message>
    <message>
        <source>pivot O₂</source>
        <translation>pivote O₂</translation>
    </message>
    <message>
        <source>pin A</source>
        <translation>pasador A</translation>
    </message>
    <message>
        <source>pin B</source>
        <translation>pasador B</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>guía</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>restricción motriz</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>iteración</translation>
    </message>
    <message>
        <source>‖C‖, relative</source>
        <translation>‖C‖, relativo</translation>
    </message>
    <message>
        <source>‖C‖</source>
        <translation>‖C‖</translation>
    </message>
    <message>
        <source>Equations, a row for each constraint</source>
        <translation>Ecuaciones, una fila por restricción</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>par</translation>
    </message>
    <message>
        <source>Joint that the equation describes</source>
        <translation>Par que describe la ecuación</translation>
    </message>
    <message>
        <source>equation</source>
        <translation>ecuación</translation>
    </message>
    <message>
        <source>C(q, t) = 0; bodies as superscripts: 1 ground, 2 crank, 3 coupler, 4 slider</source>
        <translation>C(q, t) = 0; los cuerpos como superíndices: 1 bancada, 2 manivela, 3 biela, 4 corredera</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Residual of the equation</source>
        <translation>Residuo de la ecuación</translation>
    </message>
    <message>
        <source>Cₜ, per s</source>
        <translation>Cₜ, por s</translation>
    </message>
    <message>
        <source>∂C/∂t: the velocities follow from C&lt;sub&gt;q&lt;/sub&gt; dq/dt = −Cₜ</source>
        <translation>∂C/∂t: las velocidades resultan de C&lt;sub&gt;q&lt;/sub&gt; dq/dt = −Cₜ</translation>
    </message>
    <message>
        <source>Q_d, per s²</source>
        <translation>Q_d, por s²</translation>
    </message>
    <message>
        <source>The accelerations follow from C&lt;sub&gt;q&lt;/sub&gt; d²q/dt² = Q&lt;sub&gt;d&lt;/sub&gt;</source>
        <translation>Las aceleraciones resultan de C&lt;sub&gt;q&lt;/sub&gt; d²q/dt² = Q&lt;sub&gt;d&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>Unit of C; Cₜ has this unit per s, Q&lt;sub&gt;d&lt;/sub&gt; per s²</source>
        <translation>Unidad de C; Cₜ tiene esta unidad por s, Q&lt;sub&gt;d&lt;/sub&gt; por s²</translation>
    </message>
    <message>
        <source>Jacobian C_q, a row for each constraint, a column for each coordinate</source>
        <translation>Jacobiano C_q, una fila por restricción y una columna por coordenada</translation>
    </message>
    <message>
        <source>C_q</source>
        <translation>C_q</translation>
    </message>
    <message>
        <source>Centre of mass of the %1</source>
        <translation>Centro de masa: %1</translation>
    </message>
    <message>
        <source>From a rough start: θ₂ exact, θ³ = 0 (crossed: 180°)</source>
        <translation>Desde una estimación inicial aproximada: θ₂ exacto, θ³ = 0 (cruzada: 180°)</translation>
    </message>
    <message>
        <source>Residual ‖C‖ over the iterations</source>
        <translation>Residuo ‖C‖ a lo largo de las iteraciones</translation>
    </message>
    <message>
        <source>Iterations, a row for each</source>
        <translation>Iteraciones, una fila por iteración</translation>
    </message>
    <message>
        <source>0: the start</source>
        <translation>0: la estimación inicial</translation>
    </message>
    <message>
        <source>● ‖C‖</source>
        <translation>● ‖C‖</translation>
    </message>
    <message>
        <source>● θ³ [°]</source>
        <translation>● θ³ [°]</translation>
    </message>
    <message>
        <source>□ ‖C‖</source>
        <translation>□ ‖C‖</translation>
    </message>
    <message>
        <source>□ θ³ [°]</source>
        <translation>□ θ³ [°]</translation>
    </message>
    <message>
        <source>Near the solution each iteration doubles the number of correct digits: the line bends down.</source>
        <translation>Cerca de la solución cada iteración duplica las cifras correctas: la línea se curva hacia abajo.</translation>
    </message>
    <message>
        <source>Coordinates, a row for each</source>
        <translation>Coordenadas, una fila por coordenada</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>coordenada</translation>
    </message>
    <message>
        <source>Centre of mass and angle of each body</source>
        <translation>Centro de masa y ángulo de cada cuerpo</translation>
    </message>
    <message>
        <source>body</source>
        <translation>cuerpo</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>q; θ₂ is within a revolution</source>
        <translation>q; θ₂ está dentro de una revolución</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>dq/dt</source>
        <translation>dq/dt</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>aceleración</translation>
    </message>
    <message>
        <source>d²q/dt²</source>
        <translation>d²q/dt²</translation>
    </message>
    <message>
        <source>Units of position, velocity and acceleration</source>
        <translation>Unidades de la posición, la velocidad y la aceleración</translation>
    </message>
    <message>
        <source>∂C/∂q: a row for each constraint, a column for each coordinate.
κ is the largest singular value divided by the smallest. It depends on the unit of length, because
lengths and angles are mixed. The larger it is, the more digits are lost; it is infinite where the
coupler is perpendicular to the slider&apos;s line.</source>
        <translation>∂C/∂q: una fila por restricción, una columna por coordenada.
κ es el mayor valor singular dividido por el menor. Depende de la unidad de longitud, porque se mezclan
longitudes y ángulos. Cuanto mayor es, más cifras se pierden; es infinito donde la biela es
perpendicular a la línea de la corredera.</translation>
    </message>
    <message>
        <source>From the position %1 s before</source>
        <translation>Desde la posición %1 s antes</translation>
    </message>
    <message>
        <source>● %1. □ %2. The dashed line is the tolerance, %3.</source>
        <translation>● %1. □ %2. La línea discontinua es la tolerancia, %3.</translation>
    </message>
    <message>
        <source>Angle of the %1; lengths in %2</source>
        <translation>Ángulo: %1; longitudes en %2</translation>
    </message>
    <message>
        <source>Lengths in %1. Condition number of the Jacobian κ = %2; its determinant −b cos θ³ = %3</source>
        <translation>Longitudes en %1. Número de condición del jacobiano κ = %2; su determinante −b cos θ³ = %3</translation>
    </message>
    <message>
        <source>units</source>
        <translation>unidades</translation>
    </message>
</context>
<context>
    <name>slidercrank::NotationText</name>
    <message>
        <source>transmission angle</source>
        <translation>ángulo de transmisión</translation>
    </message>
    <message>
        <source>displacement from the outer dead centre</source>
        <translation>desplazamiento desde el punto muerto exterior</translation>
    </message>
    <message>
        <source>crank pin A in x</source>
        <translation>pasador A de la manivela en x</translation>
    </message>
    <message>
        <source>velocity of the crank pin A in x</source>
        <translation>velocidad del pasador A de la manivela en x</translation>
    </message>
    <message>
        <source>acceleration of the crank pin A in x</source>
        <translation>aceleración del pasador A de la manivela en x</translation>
    </message>
    <message>
        <source>crank pin A in y</source>
        <translation>pasador A de la manivela en y</translation>
    </message>
    <message>
        <source>velocity of the crank pin A in y</source>
        <translation>velocidad del pasador A de la manivela en y</translation>
    </message>
    <message>
        <source>acceleration of the crank pin A in y</source>
        <translation>aceleración del pasador A de la manivela en y</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>%1, first derivative</source>
        <translation>%1, primera derivada</translation>
    </message>
    <message>
        <source>%1, second derivative</source>
        <translation>%1, segunda derivada</translation>
    </message>
</context>
<context>
    <name>slidercrank::NumberBox</name>
    <message>
        <source>This must be a whole number from %1 to %2.</source>
        <translation>Debe ser un número entero de %1 a %2.</translation>
    </message>
    <message>
        <source>This must be at least %1.</source>
        <translation>Debe ser como mínimo %1.</translation>
    </message>
    <message>
        <source>This must be at most %1.</source>
        <translation>Debe ser como máximo %1.</translation>
    </message>
    <message>
        <source>This must be greater than 0.</source>
        <translation>Debe ser mayor que 0.</translation>
    </message>
</context>
<context>
    <name>slidercrank::ParameterPanel</name>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>Length of the crank, O₂ to A</source>
        <translation>Longitud de la manivela, de O₂ a A</translation>
    </message>
    <message>
        <source>Length of the coupler, A to B</source>
        <translation>Longitud de la biela, de A a B</translation>
    </message>
    <message>
        <source>Height of the slider&apos;s line above O₂; may be negative</source>
        <translation>Excentricidad: altura de la línea de la corredera sobre O₂; puede ser negativa</translation>
    </message>
    <message>
        <source>Angle of the crank at t = 0</source>
        <translation>Ángulo de la manivela en t = 0</translation>
    </message>
    <message>
        <source>Parameters of the mechanism</source>
        <translation>Parámetros del mecanismo</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, control deslizante</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unidad de %1</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Restablecer %1</translation>
    </message>
    <message>
        <source>Back to the initial value</source>
        <translation>Volver al valor inicial</translation>
    </message>
    <message>
        <source>Angular velocity of the crank, counter-clockwise positive</source>
        <translation>Velocidad angular de la manivela, positiva en sentido antihorario</translation>
    </message>
    <message>
        <source>Click to see how the limits of the motion depend on %1</source>
        <translation>Haga clic para ver cómo dependen de %1 los límites del movimiento</translation>
    </message>
</context>
<context>
    <name>slidercrank::PlotFigure</name>
    <message>
        <source>% of peak</source>
        <translation>% del máx.</translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation>no está en el archivo</translation>
    </message>
    <message>
        <source>nothing to compare</source>
        <translation>nada que comparar</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modelo</translation>
    </message>
    <message>
        <source>file&apos;s rounding</source>
        <translation>redondeo del archivo</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>sin diferencia</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ángulo</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>aceleración</translation>
    </message>
    <message>
        <source>the mechanism cannot be assembled</source>
        <translation>el mecanismo no se puede ensamblar</translation>
    </message>
    <message>
        <source>error of the coupler</source>
        <translation>error de la biela</translation>
    </message>
    <message>
        <source>error of the slider</source>
        <translation>error de la corredera</translation>
    </message>
    <message>
        <source>undefined: the reference is 0</source>
        <translation>sin definir: la referencia es 0</translation>
    </message>
    <message>
        <source>position error</source>
        <translation>error de posición</translation>
    </message>
    <message>
        <source>position difference from %1</source>
        <translation>diferencia de posición respecto a %1</translation>
    </message>
    <message>
        <source>position difference</source>
        <translation>diferencia de posición</translation>
    </message>
    <message>
        <source>velocity error</source>
        <translation>error de velocidad</translation>
    </message>
    <message>
        <source>velocity difference from %1</source>
        <translation>diferencia de velocidad respecto a %1</translation>
    </message>
    <message>
        <source>velocity difference</source>
        <translation>diferencia de velocidad</translation>
    </message>
    <message>
        <source>acceleration error</source>
        <translation>error de aceleración</translation>
    </message>
    <message>
        <source>acceleration difference from %1</source>
        <translation>diferencia de aceleración respecto a %1</translation>
    </message>
    <message>
        <source>acceleration difference</source>
        <translation>diferencia de aceleración</translation>
    </message>
    <message>
        <source>no time step is solved</source>
        <translation>no se resuelve ningún paso de tiempo</translation>
    </message>
    <message>
        <source>difference of the coupler from %1</source>
        <translation>diferencia de la biela respecto a %1</translation>
    </message>
    <message>
        <source>difference of the slider from %1</source>
        <translation>diferencia de la corredera respecto a %1</translation>
    </message>
    <message>
        <source>≈ time step: %1</source>
        <translation>≈ paso de tiempo: %1</translation>
    </message>
    <message>
        <source>≈ file: %1</source>
        <translation>≈ archivo: %1</translation>
    </message>
    <message>
        <source>%1 (gaps: cannot be assembled)</source>
        <translation>%1 (sin curva donde no se puede ensamblar)</translation>
    </message>
</context>
<context>
    <name>slidercrank::PlotGrid</name>
    <message>
        <source>Plots of the motion</source>
        <translation>Gráficas del movimiento</translation>
    </message>
    <message>
        <source>&amp;Maximize this plot</source>
        <translation>&amp;Maximizar esta gráfica</translation>
    </message>
    <message>
        <source>&amp;Copy this plot</source>
        <translation>&amp;Copiar esta gráfica</translation>
    </message>
    <message>
        <source>&amp;Export this plot…</source>
        <translation>&amp;Exportar esta gráfica…</translation>
    </message>
    <message>
        <source>Error in &amp;% of the reference</source>
        <translation>Error en &amp;% de la referencia</translation>
    </message>
    <message>
        <source>Error in % of the &amp;peak</source>
        <translation>Error en % del má&amp;ximo</translation>
    </message>
    <message>
        <source>&amp;Logarithmic errors</source>
        <translation>Errores &amp;logarítmicos</translation>
    </message>
    <message>
        <source>Over the crank &amp;angle</source>
        <translation>Sobre el án&amp;gulo de la manivela</translation>
    </message>
    <message>
        <source>A&amp;bsolute error</source>
        <translation>Error absol&amp;uto</translation>
    </message>
    <message>
        <source>To compare with a simulation, &lt;a href=&quot;open&quot;&gt;open its CSV…&lt;/a&gt; or drop it here.</source>
        <translation>Para comparar con una simulación, &lt;a href=&quot;open&quot;&gt;abra su CSV…&lt;/a&gt; o suéltelo aquí.</translation>
    </message>
    <message>
        <source>Show all plots agai&amp;n</source>
        <translation>Mostrar de &amp;nuevo todas las gráficas</translation>
    </message>
    <message>
        <source>Copy the &amp;values here</source>
        <translation>Copiar los &amp;valores de aquí</translation>
    </message>
    <message>
        <source>Reset plot &amp;zoom</source>
        <translation>Restablecer el &amp;zoom de las gráficas</translation>
    </message>
    <message>
        <source>File&apos;s &amp;rounding</source>
        <translation>&amp;Redondeo del archivo</translation>
    </message>
</context>
<context>
    <name>slidercrank::PolygonView</name>
    <message>
        <source>Velocity and acceleration polygons</source>
        <translation>Polígonos de velocidades y de aceleraciones</translation>
    </message>
    <message>
        <source>Velocity and acceleration polygons at the present position; α₂ is that of the table.</source>
        <translation>Polígonos de velocidades y de aceleraciones en la posición actual; α₂ es la de la tabla.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copies the polygons as an image</source>
        <translation>Copia los polígonos como imagen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Writes the polygons to an image file</source>
        <translation>Escribe los polígonos en un archivo de imagen</translation>
    </message>
    <message>
        <source>polygons</source>
        <translation>polígonos</translation>
    </message>
    <message>
        <source>The polygons are in the clipboard.</source>
        <translation>Los polígonos están en el portapapeles.</translation>
    </message>
</context>
<context>
    <name>slidercrank::QuantityText</name>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>Write the decimal sign as “%1”: %2.</source>
        <translation>Escriba el signo decimal como «%1»: %2.</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>«%1» es demasiado grande.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>“%1”: enter this number without a unit.</source>
        <translation>«%1»: escriba este número sin unidad.</translation>
    </message>
    <message>
        <source>A comma is not accepted: write %1, or %2 if it separates thousands.</source>
        <translation>No se admite una coma: escriba %1, o %2 si separa los miles.</translation>
    </message>
    <message>
        <source>“%1”: use a unit such as %2.</source>
        <translation>«%1»: use una unidad como %2.</translation>
    </message>
</context>
<context>
    <name>slidercrank::ReadFaultText</name>
    <message>
        <source>two columns contain the time, or the crank angle instead of it: keep one of the two, with the columns that were sampled at it.</source>
        <translation>dos columnas contienen el tiempo, o en su lugar el ángulo de la manivela: deje una de las dos, con las columnas que se registraron con ella.</translation>
    </message>
    <message>
        <source>not a number: too large</source>
        <translation>no es un número: demasiado grande</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>no es un número</translation>
    </message>
    <message>
        <source>too many cells</source>
        <translation>demasiadas celdas</translation>
    </message>
    <message>
        <source>too few cells</source>
        <translation>faltan celdas</translation>
    </message>
    <message>
        <source>no time</source>
        <translation>sin tiempo</translation>
    </message>
    <message>
        <source>The file is a spreadsheet or an archive, not text: save the table as CSV.</source>
        <translation>El archivo es una hoja de cálculo o un archivo comprimido, no texto: guarde la tabla como CSV.</translation>
    </message>
    <message>
        <source>The file is a PDF document, not a table: export the table as CSV.</source>
        <translation>El archivo es un documento PDF, no una tabla: exporte la tabla como CSV.</translation>
    </message>
    <message>
        <source>The file is HTML or XML, not a table of text: export the table as CSV.</source>
        <translation>El archivo es HTML o XML, no una tabla de texto: exporte la tabla como CSV.</translation>
    </message>
    <message>
        <source>The file is JSON, not a table of text: export the table as CSV.</source>
        <translation>El archivo es JSON, no una tabla de texto: exporte la tabla como CSV.</translation>
    </message>
    <message>
        <source>the file holds bytes that are not text: export the table as CSV.</source>
        <translation>el archivo contiene bytes que no son texto: exporte la tabla como CSV.</translation>
    </message>
    <message>
        <source>The file is a text without rows of numbers: export the motion as a table, with a line of headings and one row for each time stamp.</source>
        <translation>El archivo es un texto sin filas de números: exporte el movimiento como tabla, con una línea de encabezados y una fila por cada instante.</translation>
    </message>
    <message>
        <source>Reading was stopped.</source>
        <translation>Se detuvo la lectura.</translation>
    </message>
    <message>
        <source>the line of units contradicts the heading, %1: correct one of the two.</source>
        <translation>la línea de unidades contradice el encabezado, %1: corrija uno de los dos.</translation>
    </message>
    <message>
        <source>the line has more than a million characters: export the table as CSV, with one row per line.</source>
        <translation>la línea tiene más de un millón de caracteres: exporte la tabla como CSV, una fila por línea.</translation>
    </message>
    <message>
        <source>there is no column “%1”.</source>
        <translation>no hay ninguna columna «%1».</translation>
    </message>
    <message>
        <source>The file is larger than 2 GB: export fewer rows or columns.</source>
        <translation>El archivo ocupa más de 2 GB: exporte menos filas o columnas.</translation>
    </message>
    <message>
        <source>The file is empty: it needs a line of headings, and numbers below it.</source>
        <translation>El archivo está vacío: necesita una línea de encabezados y números debajo.</translation>
    </message>
    <message>
        <source>numbers where the headings should be: put a line such as time,theta3,R4_x above them.</source>
        <translation>hay números donde deberían estar los encabezados: ponga encima una línea como time,theta3,R4_x.</translation>
    </message>
    <message>
        <source>unknown unit, or one of another quantity: write for example [%2], or none.</source>
        <translation>unidad desconocida o de otra magnitud: escriba, por ejemplo, [%2], o ninguna.</translation>
    </message>
    <message>
        <source>unknown unit of time: write [s] or [ms], or none for seconds.</source>
        <translation>unidad de tiempo desconocida: escriba [s] o [ms], o ninguna si son segundos.</translation>
    </message>
    <message>
        <source>several columns are called “%1”: give the number of one of them, as in #3.</source>
        <translation>varias columnas se llaman «%1»: indique el número de una de ellas, como en #3.</translation>
    </message>
    <message>
        <source>two columns contain %2: keep one of the two.</source>
        <translation>dos columnas contienen %2: deje una de las dos.</translation>
    </message>
    <message>
        <source>there is no time column: call the column of the time stamps “time”, or that of the crank angle “theta2”.</source>
        <translation>no hay columna de tiempo: llame «time» a la columna de los instantes, o «theta2» a la del ángulo de la manivela.</translation>
    </message>
    <message>
        <source>no column other than the time has a known heading: use theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2.</source>
        <translation>ninguna columna, aparte del tiempo, tiene un encabezado conocido: use theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2.</translation>
    </message>
    <message>
        <source>no column besides the time or crank angle can be used (%1: %4): use the headings theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2.</source>
        <translation>aparte del tiempo o del ángulo de la manivela, no se puede usar ninguna columna (%1: %4): use los encabezados theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2.</translation>
    </message>
    <message>
        <source>there are no numbers below the headings.</source>
        <translation>no hay números debajo de los encabezados.</translation>
    </message>
    <message>
        <source>no row can be read, this one because of: %3. Write numbers as 0.005, or as 0,005 with columns separated by semicolons or tabs.</source>
        <translation>no se puede leer ninguna fila, y esta por: %3. Escriba los números como 0.005, o como 0,005 con las columnas separadas por punto y coma o tabuladores.</translation>
    </message>
    <message>
        <source>most rows cannot be read, the first one because of: %3. Write every value as a number, such as 0.005, or leave the column out.</source>
        <translation>no se puede leer la mayoría de las filas; la primera, por: %3. Escriba cada valor como un número, por ejemplo 0.005, o deje fuera la columna.</translation>
    </message>
    <message>
        <source>no column other than the time contains a number.</source>
        <translation>ninguna columna, aparte del tiempo, contiene un número.</translation>
    </message>
    <message>
        <source>there are %5 headings, but at most %6 cells in each row: put headings that contain the delimiter in quotation marks.</source>
        <translation>hay %5 encabezados, pero como máximo %6 celdas en cada fila: ponga entre comillas los encabezados que contengan el separador.</translation>
    </message>
    <message>
        <source>there are %5 headings, but %6 cells in the row: give every column a heading.</source>
        <translation>hay %5 encabezados, pero %6 celdas en la fila: ponga un encabezado a cada columna.</translation>
    </message>
    <message>
        <source>the numbers below have to be multiplied by this factor: print them in full, in MATLAB and Octave with “format long g”.</source>
        <translation>los números siguientes deben multiplicarse por este factor: escríbalos completos, en MATLAB y Octave con «format long g».</translation>
    </message>
    <message>
        <source>the quantities are rows: transpose the table, so that each quantity is a column.</source>
        <translation>las magnitudes están en filas: trasponga la tabla, de modo que cada magnitud sea una columna.</translation>
    </message>
    <message>
        <source>another table begins here, with other headings or units: keep one of the tables.</source>
        <translation>aquí empieza otra tabla, con otros encabezados o unidades: conserve una de las tablas.</translation>
    </message>
    <message>
        <source>the time starts again: this file holds several motions; keep one of them.</source>
        <translation>el tiempo vuelve a empezar: este archivo contiene varios movimientos; conserve uno de ellos.</translation>
    </message>
    <message>
        <source>the angle starts again: this file holds several motions; keep one of them.</source>
        <translation>el ángulo vuelve a empezar: este archivo contiene varios movimientos; conserve uno de ellos.</translation>
    </message>
    <message>
        <source>the time does not increase: sort the rows by time, and write it with more decimals if many rows have the same time.</source>
        <translation>el tiempo no crece: ordene las filas por tiempo, y escríbalo con más decimales si muchas filas tienen el mismo.</translation>
    </message>
    <message>
        <source>the crank angle goes back: sort the rows by it, and keep one row for each angle.</source>
        <translation>el ángulo de la manivela retrocede: ordene las filas por él y deje una fila por ángulo.</translation>
    </message>
    <message>
        <source>its time stamps are not those of %1: export the plots with the same start, end and step, or open one file at a time.</source>
        <translation>sus instantes no son los de %1: exporte las gráficas con el mismo inicio, fin y paso, o abra los archivos de uno en uno.</translation>
    </message>
    <message>
        <source>both this file and %1 contain %2: leave one of them out, or choose the meaning of their columns.</source>
        <translation>tanto este archivo como %1 contienen %2: deje fuera uno de los dos, o elija el significado de sus columnas.</translation>
    </message>
    <message>
        <source>not a number: this file uses a decimal comma</source>
        <translation>no es un número: este archivo usa coma decimal</translation>
    </message>
    <message>
        <source>not a number: this file uses a decimal point</source>
        <translation>no es un número: este archivo usa punto decimal</translation>
    </message>
    <message>
        <source>the same time as the next row, which is used</source>
        <translation>el mismo tiempo que la fila siguiente, que es la que se usa</translation>
    </message>
    <message>
        <source>There is not enough memory: leave out rows or columns.</source>
        <translation>No hay memoria suficiente: deje fuera filas o columnas.</translation>
    </message>
</context>
<context>
    <name>slidercrank::Recovery</name>
    <message>
        <source>Restore</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>The program ended before your changes were saved. They are kept, as of %1.</source>
        <translation>El programa terminó antes de que se guardaran sus cambios. Se conservan los del %1.</translation>
    </message>
    <message>
        <source>d MMMM yyyy, HH:mm</source>
        <translation>d &apos;de&apos; MMMM &apos;de&apos; yyyy, HH:mm</translation>
    </message>
</context>
<context>
    <name>slidercrank::ReferenceFileText</name>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, línea %2: %3</translation>
    </message>
    <message>
        <source>%1, line %2, column %3 (“%4”): %5</source>
        <translation>%1, línea %2, columna %3 («%4»): %5</translation>
    </message>
    <message>
        <source>The columns are: %1.</source>
        <translation>Las columnas son: %1.</translation>
    </message>
    <message>
        <source>%1 Or add %2</source>
        <translation>%1 O añada %2</translation>
    </message>
    <message>
        <source>%1 + %2 more</source>
        <translation>%1 + %2 más</translation>
    </message>
    <message>
        <source>%1 is a folder: choose a file in it.</source>
        <translation>%1 es una carpeta: elija un archivo de ella.</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2.</source>
        <translation>No se puede abrir %1: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>No se puede leer %1: %2.</translation>
    </message>
    <message>
        <source>%1 lists crank angles in an order that a crank with ω₂ = %2 cannot reach: choose a different ω₂.</source>
        <translation>%1 enumera ángulos de la manivela en un orden que una manivela con ω₂ = %2 no puede recorrer: elija otra ω₂.</translation>
    </message>
</context>
<context>
    <name>slidercrank::ReferencePage</name>
    <message>
        <source>Columns of the file, a row for each</source>
        <translation>Columnas del archivo, una fila por columna</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>encabezado</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>read as</source>
        <translation>se lee como</translation>
    </message>
    <message>
        <source>rounded to</source>
        <translation>paso de redondeo</translation>
    </message>
    <message>
        <source>Inferred from all values of the column</source>
        <translation>Deducido de todos los valores de la columna</translation>
    </message>
    <message>
        <source>values</source>
        <translation>valores</translation>
    </message>
    <message>
        <source>why</source>
        <translation>motivo</translation>
    </message>
    <message>
        <source>Rows of the file that were skipped</source>
        <translation>Filas del archivo que se omitieron</translation>
    </message>
    <message>
        <source>skipped line</source>
        <translation>línea omitida</translation>
    </message>
    <message>
        <source>column</source>
        <translation>columna</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texto</translation>
    </message>
    <message>
        <source>Searching for the mechanism of this file…</source>
        <translation>Buscando el mecanismo de este archivo…</translation>
    </message>
    <message>
        <source>No file is open.</source>
        <translation>No hay ningún archivo abierto.</translation>
    </message>
    <message>
        <source>Choose columns…</source>
        <translation>Elegir columnas…</translation>
    </message>
    <message>
        <source>%1, gaps: %2</source>
        <translation>%1, huecos: %2</translation>
    </message>
    <message>
        <source>%1. Rows: %2.</source>
        <translation>%1. Filas: %2.</translation>
    </message>
    <message>
        <source>The rows are indexed by the crank angle; ω₂ and θ₂₀ give the time.</source>
        <translation>Las filas están dadas en función del ángulo de la manivela; ω₂ y θ₂₀ dan el tiempo.</translation>
    </message>
</context>
<context>
    <name>slidercrank::Report</name>
    <message>
        <source>model</source>
        <translation>modelo</translation>
    </message>
    <message>
        <source>assembly</source>
        <translation>configuración</translation>
    </message>
    <message>
        <source>Errors: model against reference</source>
        <translation>Errores: modelo frente a referencia</translation>
    </message>
    <message>
        <source>Motion of an offset slider-crank</source>
        <translation>Movimiento de un mecanismo biela-manivela descentrado</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>%1, by %2 %3</source>
        <translation>%1, por %2 %3</translation>
    </message>
    <message>
        <source>The motion limits and the plots are those of a constant crank speed, without α₂.</source>
        <translation>Los límites del movimiento y las gráficas corresponden a una velocidad constante de la manivela, sin α₂.</translation>
    </message>
    <message>
        <source>Closed form, exact to rounding.</source>
        <translation>Forma cerrada, exacta salvo redondeo.</translation>
    </message>
    <message>
        <source>absolute</source>
        <translation>absoluta</translation>
    </message>
    <message>
        <source>relative</source>
        <translation>relativa</translation>
    </message>
    <message>
        <source>%1 time steps from t = %2 s to %3 s, %4 of them solved.</source>
        <translation>%1 pasos de tiempo de t = %2 s a %3 s, %4 de ellos resueltos.</translation>
    </message>
    <message>
        <source>Motion limits</source>
        <translation>Límites del movimiento</translation>
    </message>
    <message>
        <source>Found by weighted least squares; ± is one standard error.</source>
        <translation>Hallado por mínimos cuadrados ponderados; ± es un error estándar.</translation>
    </message>
    <message>
        <source>Thin lines: the motion in the file.</source>
        <translation>Líneas finas: el movimiento del archivo.</translation>
    </message>
    <message>
        <source>Thin lines: the pinned mechanism.</source>
        <translation>Líneas finas: el mecanismo fijado.</translation>
    </message>
    <message>
        <source>coupler</source>
        <translation>biela</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>corredera</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>aceleración</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>magnitud</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>error máximo</translation>
    </message>
    <message>
        <source>The plots show t = %1 s to %2 s.</source>
        <translation>Las gráficas muestran de t = %1 s a %2 s.</translation>
    </message>
    <message>
        <source>Thin curves: the pinned motions (%1).</source>
        <translation>Curvas finas: los movimientos fijados (%1).</translation>
    </message>
    <message>
        <source>largest difference</source>
        <translation>diferencia máxima</translation>
    </message>
    <message numerus="yes">
        <source>%n time steps: %1</source>
        <translation>
            <numerusform>%n paso de tiempo: %1</numerusform>
            <numerusform>%n pasos de tiempo: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>at θ₂ [%1]</source>
        <translation>en θ₂ [%1]</translation>
    </message>
    <message>
        <source>at t [s]</source>
        <translation>en t [s]</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>% of peak</source>
        <translation>% del máximo</translation>
    </message>
    <message>
        <source>rounding step</source>
        <translation>paso de redondeo</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>veredicto</translation>
    </message>
    <message>
        <source>Rounding step: the largest spacing between neighbouring values of the file.</source>
        <translation>Paso de redondeo: la mayor separación entre valores consecutivos del archivo.</translation>
    </message>
    <message>
        <source>Difference from the pinned motion</source>
        <translation>Diferencia respecto al movimiento fijado</translation>
    </message>
    <message>
        <source>The model is compared with the pinned motion (%1).</source>
        <translation>El modelo se compara con el movimiento fijado (%1).</translation>
    </message>
    <message>
        <source>The mechanism at %1.</source>
        <translation>El mecanismo en %1.</translation>
    </message>
    <message>
        <source>d MMMM yyyy, HH:mm</source>
        <translation>d &apos;de&apos; MMMM &apos;de&apos; yyyy, HH:mm</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>En %1</translation>
    </message>
    <message numerus="yes">
        <source>Reference: %1, %2, %n rows.</source>
        <translation>
            <numerusform>Referencia: %1, %2, %n fila.</numerusform>
            <numerusform>Referencia: %1, %2, %n filas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Newton-Raphson in the 12 absolute coordinates: tolerance %1 (%2), at most %n iterations per time step. Iterations: %3; largest residual: %4.</source>
        <translation>
            <numerusform>Newton-Raphson en las 12 coordenadas absolutas: tolerancia %1 (%2), a lo sumo %n iteración por paso de tiempo. Iteraciones: %3; residuo máximo: %4.</numerusform>
            <numerusform>Newton-Raphson en las 12 coordenadas absolutas: tolerancia %1 (%2), a lo sumo %n iteraciones por paso de tiempo. Iteraciones: %3; residuo máximo: %4.</numerusform>
        </translation>
    </message>
    <message>
        <source>Without a time: angles that the crank does not reach within the time range.</source>
        <translation>Sin tiempo: ángulos que la manivela no alcanza en el intervalo de tiempo.</translation>
    </message>
    <message>
        <source>Without a value: angles at which the mechanism cannot be assembled, or at which the velocities do not exist.</source>
        <translation>Sin valor: ángulos en los que el mecanismo no se puede ensamblar o en los que las velocidades no existen.</translation>
    </message>
    <message>
        <source>Table, every %1%2</source>
        <translation>Tabla, cada %1%2</translation>
    </message>
    <message>
        <source>Further columns of the table</source>
        <translation>Otras columnas de la tabla</translation>
    </message>
    <message>
        <source>Velocity and acceleration polygons</source>
        <translation>Polígonos de velocidades y de aceleraciones</translation>
    </message>
</context>
<context>
    <name>slidercrank::ReportLayout</name>
    <message>
        <source>page %1 of %2</source>
        <translation>página %1 de %2</translation>
    </message>
    <message>
        <source>Motion of an offset slider-crank</source>
        <translation>Movimiento de un mecanismo biela-manivela descentrado</translation>
    </message>
</context>
<context>
    <name>slidercrank::ResponseText</name>
    <message>
        <source>The crank makes full turns for no value of %1.</source>
        <translation>La manivela no da vueltas completas con ningún valor de %1.</translation>
    </message>
    <message>
        <source>The crank makes full turns for %1 ≤ %2 ≤ %3; the rest is shaded.</source>
        <translation>La manivela da vueltas completas para %1 ≤ %2 ≤ %3; el resto está sombreado.</translation>
    </message>
    <message>
        <source>The crank makes full turns for %1 ≥ %2; the rest is shaded.</source>
        <translation>La manivela da vueltas completas para %1 ≥ %2; el resto está sombreado.</translation>
    </message>
    <message>
        <source>The crank makes full turns for %1 ≤ %2; the rest is shaded.</source>
        <translation>La manivela da vueltas completas para %1 ≤ %2; el resto está sombreado.</translation>
    </message>
</context>
<context>
    <name>slidercrank::ResponseView</name>
    <message>
        <source>Parameter that is varied</source>
        <translation>Parámetro que se varía</translation>
    </message>
    <message>
        <source>How the limits depend on a parameter</source>
        <translation>Cómo dependen los límites de un parámetro</translation>
    </message>
    <message>
        <source>Response to %1</source>
        <translation>Respuesta a %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copies the charts as an image</source>
        <translation>Copia las gráficas como imagen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Writes the charts to an image file, or the numbers of the curves to a CSV file</source>
        <translation>Escribe las gráficas en un archivo de imagen, o los números de las curvas en un archivo CSV</translation>
    </message>
    <message>
        <source>Figure…</source>
        <translation>Figura…</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabla…</translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation>%1 [%2]</translation>
    </message>
    <message>
        <source>Drag a dot to change %1.</source>
        <translation>Arrastre un punto para cambiar %1.</translation>
    </message>
    <message>
        <source>The charts are in the clipboard.</source>
        <translation>Las gráficas están en el portapapeles.</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>response</source>
        <translation>respuesta</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>stroke [%1]</source>
        <translation>carrera [%1]</translation>
    </message>
    <message>
        <source>min. transmission angle [%1]</source>
        <translation>áng. de transmisión mín. [%1]</translation>
    </message>
    <message>
        <source>peak slider speed [%1]</source>
        <translation>pico de vel. de la corredera [%1]</translation>
    </message>
    <message>
        <source>peak slider acc. [%1]</source>
        <translation>pico de acel. de la corredera [%1]</translation>
    </message>
    <message>
        <source>Hollow dots: pinned motions, %1.</source>
        <translation>Puntos huecos: movimientos fijados, %1.</translation>
    </message>
</context>
<context>
    <name>slidercrank::SaveDialogText</name>
    <message>
        <source>PNG images (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawings (*.svg)</source>
        <translation>Dibujos SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documentos PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>slidercrank::SceneFile</name>
    <message>
        <source>Changed elsewhere</source>
        <translation>Cambiado en otra parte</translation>
    </message>
    <message>
        <source>%1 has been changed by another program since you opened it. Replace it?</source>
        <translation>Otro programa ha cambiado %1 desde que usted lo abrió. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Guardar escena</translation>
    </message>
    <message>
        <source>Scenes (*.json)</source>
        <translation>Escenas (*.json)</translation>
    </message>
    <message>
        <source>Scenes (*.slidercrank)</source>
        <translation>Escenas (*.slidercrank)</translation>
    </message>
    <message>
        <source>Save your changes as a scene?</source>
        <translation>¿Guardar los cambios como escena?</translation>
    </message>
    <message>
        <source>Save your changes to %1?</source>
        <translation>¿Guardar los cambios en %1?</translation>
    </message>
    <message>
        <source>They will be lost if you don&apos;t.</source>
        <translation>Si no los guarda, se perderán.</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>escena</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Guardado: %1</translation>
    </message>
    <message>
        <source>The link is in the clipboard. It carries the mechanism, α₂, the time steps and the method, but no file.</source>
        <translation>El enlace está en el portapapeles. Contiene el mecanismo, α₂, los pasos de tiempo y el método, pero ningún archivo.</translation>
    </message>
    <message>
        <source>The link is in the clipboard. It carries the mechanism, α₂, the time steps and the method.</source>
        <translation>El enlace está en el portapapeles. Contiene el mecanismo, α₂, los pasos de tiempo y el método.</translation>
    </message>
</context>
<context>
    <name>slidercrank::SceneLinkText</name>
    <message>
        <source>The link says %1=%2: add a unit, %2deg or %2rad.</source>
        <translation>El enlace dice %1=%2: añada una unidad, %2deg o %2rad.</translation>
    </message>
    <message>
        <source>The link says %1=%2. %3</source>
        <translation>El enlace dice %1=%2. %3</translation>
    </message>
    <message>
        <source>The link contains “%1”, which is not a setting. It is written as in %2.</source>
        <translation>El enlace contiene «%1», que no es un ajuste. Se escribe como en %2.</translation>
    </message>
    <message>
        <source>The link says %1=%2:</source>
        <translation>El enlace dice %1=%2:</translation>
    </message>
    <message>
        <source>that is no choice for %1.</source>
        <translation>no es una opción de %1.</translation>
    </message>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1 debe ser un número entero de %2 a %3.</translation>
    </message>
    <message>
        <source>%1 must be between %2 and %3.</source>
        <translation>%1 debe estar entre %2 y %3.</translation>
    </message>
    <message>
        <source>The link contains %1 more than once: keep one of them.</source>
        <translation>El enlace contiene %1 más de una vez: deje solo una.</translation>
    </message>
</context>
<context>
    <name>slidercrank::SceneText</name>
    <message>
        <source>%1 is a pipe or a device: save the scene in a file, and open that.</source>
        <translation>%1 es una tubería o un dispositivo: guarde la escena en un archivo y ábralo.</translation>
    </message>
    <message>
        <source>%1, line %2: this is not JSON (%3). Correct it there, or open another scene.</source>
        <translation>%1, línea %2: esto no es JSON (%3). Corríjalo allí, o abra otra escena.</translation>
    </message>
    <message>
        <source>%1: “%2” is missing, or its value is not valid. Correct it there, or open another scene.</source>
        <translation>%1: falta «%2» o su valor no es válido. Corríjalo allí o abra otra escena.</translation>
    </message>
    <message>
        <source>%1 is not a scene: it has no “version” that is a number. Open a file that this program saved.</source>
        <translation>%1 no es una escena: no contiene un campo «version» numérico. Abra un archivo guardado por este programa.</translation>
    </message>
    <message>
        <source>%1 was saved by a newer slidercrank (scene version %2; this one reads up to %3). Open it with the newer one.</source>
        <translation>%1 se guardó con un slidercrank más nuevo (versión de escena %2; este lee hasta la %3). Ábrala con el más nuevo.</translation>
    </message>
</context>
<context>
    <name>slidercrank::SegmentedPages</name>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
</context>
<context>
    <name>slidercrank::Session</name>
    <message>
        <source>%1 must be at least %2 mm.</source>
        <translation>%1 debe ser al menos %2 mm.</translation>
    </message>
    <message>
        <source>%1 must be a number up to %2.</source>
        <translation>%1 debe ser un número de hasta %2.</translation>
    </message>
    <message>
        <source>%1 is a pipe or a device: save the data in a file, and open that.</source>
        <translation>%1 es una tubería o un dispositivo: guarde los datos en un archivo y abra ese archivo.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportado a %1</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
</context>
<context>
    <name>slidercrank::SolverForm</name>
    <message>
        <source>Settings and outcome</source>
        <translation>Ajustes y resultado</translation>
    </message>
    <message>
        <source>Newton-Raphson</source>
        <translation>Newton-Raphson</translation>
    </message>
    <message>
        <source>closed form, exact</source>
        <translation>forma cerrada, exacta</translation>
    </message>
    <message>
        <source>How the curves are computed</source>
        <translation>Cómo se calculan las curvas</translation>
    </message>
    <message>
        <source>absolute</source>
        <translation>absoluta</translation>
    </message>
    <message>
        <source>relative</source>
        <translation>relativa</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>All %1 time steps are solved.</source>
        <translation>Los %1 pasos de tiempo están resueltos.</translation>
    </message>
    <message>
        <source>Iterates until ‖C‖ is at most this; 0: until it no longer decreases</source>
        <translation>Itera hasta que ‖C‖ no supere este valor; 0: hasta que deje de disminuir</translation>
    </message>
    <message>
        <source>Absolute: mm and rad mixed. Relative: lengths divided by a + b + |c|, the same at every scale</source>
        <translation>Absoluta: mm y rad mezclados. Relativa: longitudes divididas por a + b + |c|, igual en cualquier escala</translation>
    </message>
    <message>
        <source>At one time step</source>
        <translation>En un instante</translation>
    </message>
    <message>
        <source>Tolerance type</source>
        <translation>Tipo de tolerancia</translation>
    </message>
    <message>
        <source>Maximum iterations</source>
        <translation>Máximo de iteraciones</translation>
    </message>
    <message>
        <source>cannot be assembled at %1 of %2 time steps</source>
        <translation>no se puede ensamblar en %1 de %2 pasos de tiempo</translation>
    </message>
    <message>
        <source>%1 of %2 time steps not solved</source>
        <translation>%1 de %2 pasos de tiempo sin resolver</translation>
    </message>
    <message>
        <source>iterations: %1</source>
        <translation>iteraciones: %1</translation>
    </message>
    <message>
        <source>residual %1</source>
        <translation>residuo %1</translation>
    </message>
    <message>
        <source>%1 samples in %2 ms</source>
        <translation>%1 muestras en %2 ms</translation>
    </message>
    <message>
        <source>⚠ %1 of %2 time steps: %3</source>
        <translation>⚠ %1 de %2 pasos de tiempo: %3</translation>
    </message>
</context>
<context>
    <name>slidercrank::StatusBar</name>
    <message>
        <source>Computing</source>
        <translation>Calculando</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>slidercrank::StudyPage</name>
    <message>
        <source>The same, started from position, velocity and acceleration of the time step before (Taylor series)</source>
        <translation>Lo mismo, a partir de la posición, la velocidad y la aceleración del paso de tiempo anterior (serie de Taylor)</translation>
    </message>
    <message>
        <source>Newton-Raphson, dense</source>
        <translation>Newton-Raphson, denso</translation>
    </message>
    <message>
        <source>The textbook&apos;s method: 12 equations solved together (dense LU), started from the time step before</source>
        <translation>El método del libro: 12 ecuaciones resueltas juntas (LU denso), a partir del paso de tiempo anterior</translation>
    </message>
    <message>
        <source>dense, Taylor start</source>
        <translation>denso, inicio de Taylor</translation>
    </message>
    <message>
        <source>Newton-Raphson, structured</source>
        <translation>Newton-Raphson, estructurado</translation>
    </message>
    <message>
        <source>The same 12 equations, solved joint by joint</source>
        <translation>Las mismas 12 ecuaciones, resueltas par por par</translation>
    </message>
    <message>
        <source>structured, Taylor start</source>
        <translation>estructurado, inicio de Taylor</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>forma cerrada</translation>
    </message>
    <message>
        <source>The exact formulas, one time step after the other</source>
        <translation>Las fórmulas exactas, un paso de tiempo tras otro</translation>
    </message>
    <message>
        <source>closed form, batch</source>
        <translation>forma cerrada, en lote</translation>
    </message>
    <message>
        <source>The exact formulas for several time steps at once (vector instructions)</source>
        <translation>Las fórmulas exactas para varios pasos de tiempo a la vez (instrucciones vectoriales)</translation>
    </message>
    <message>
        <source>finite differences</source>
        <translation>diferencias finitas</translation>
    </message>
    <message>
        <source>Velocity and acceleration as central differences of exact positions</source>
        <translation>Velocidad y aceleración como diferencias centrales de posiciones exactas</translation>
    </message>
    <message>
        <source>Fourier series</source>
        <translation>serie de Fourier</translation>
    </message>
    <message>
        <source>The motion as a Fourier series</source>
        <translation>El movimiento como serie de Fourier</translation>
    </message>
    <message>
        <source>%1, %2 harmonics</source>
        <translation>%1, %2 armónicos</translation>
    </message>
    <message>
        <source>solved</source>
        <translation>resueltos</translation>
    </message>
    <message>
        <source>singular</source>
        <translation>singulares</translation>
    </message>
    <message>
        <source>not converged</source>
        <translation>no convergentes</translation>
    </message>
    <message>
        <source>cannot be assembled</source>
        <translation>no ensamblables</translation>
    </message>
    <message>
        <source>not finite</source>
        <translation>no finitos</translation>
    </message>
    <message>
        <source>, %1 reported as solved but wrong</source>
        <translation>, %1 dados por resueltos pero erróneos</translation>
    </message>
    <message>
        <source>%1 ns per time step (± %2), %3 channels</source>
        <translation>%1 ns por paso de tiempo (± %2), %3 canales</translation>
    </message>
    <message>
        <source>Largest error: %1 of the peak</source>
        <translation>Error máximo: %1 del valor máximo del canal</translation>
    </message>
    <message>
        <source>No time step is solved</source>
        <translation>No se resuelve ningún paso de tiempo</translation>
    </message>
    <message>
        <source>Rounding a, b, c, ω₂, θ₂₀ and t to doubles alone may cause an error of %1</source>
        <translation>El solo redondeo de a, b, c, ω₂, θ₂₀ y t a double puede causar un error de %1</translation>
    </message>
    <message>
        <source>How the motion is computed</source>
        <translation>Cómo se calcula el movimiento</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolerancia</translation>
    </message>
    <message>
        <source>time [ns]</source>
        <translation>tiempo [ns]</translation>
    </message>
    <message>
        <source>Position, velocity and acceleration at one time step: median over interleaved rounds</source>
        <translation>Posición, velocidad y aceleración en un paso de tiempo: mediana de rondas intercaladas</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
    </message>
    <message>
        <source>Largest error of the six plotted channels, relative to the peak of the channel, over the time steps solved</source>
        <translation>Error máximo de los seis canales representados, relativo al máximo del canal, en los pasos de tiempo resueltos</translation>
    </message>
    <message>
        <source>iterations</source>
        <translation>iteraciones</translation>
    </message>
    <message>
        <source>For each time step</source>
        <translation>Por paso de tiempo</translation>
    </message>
    <message>
        <source>time steps</source>
        <translation>pasos de tiempo</translation>
    </message>
    <message>
        <source>What the method reports</source>
        <translation>Lo que informa el método</translation>
    </message>
    <message>
        <source>time for one time step [ns]</source>
        <translation>tiempo por paso de tiempo [ns]</translation>
    </message>
    <message>
        <source>error / peak</source>
        <translation>error / máximo</translation>
    </message>
    <message>
        <source>effect of rounded input</source>
        <translation>efecto de los datos redondeados</translation>
    </message>
    <message>
        <source>Error against time for each method</source>
        <translation>Error frente a tiempo de cada método</translation>
    </message>
    <message>
        <source>Tolerance of Newton-Raphson: absolute for the textbook&apos;s dense method, relative for the others</source>
        <translation>Tolerancia de Newton-Raphson: absoluta para el método denso del libro, relativa para los demás</translation>
    </message>
    <message>
        <source>Methods, a row for each method and tolerance</source>
        <translation>Métodos, una fila por método y tolerancia</translation>
    </message>
    <message>
        <source>method</source>
        <translation>método</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>canales</translation>
    </message>
    <message>
        <source>How many channels the method computes</source>
        <translation>Cuántos canales calcula el método</translation>
    </message>
</context>
<context>
    <name>slidercrank::StudyPanel</name>
    <message>
        <source>Speed and accuracy of the methods</source>
        <translation>Velocidad y exactitud de los métodos</translation>
    </message>
    <message>
        <source>%1. Measured on %2, in %3 s.</source>
        <translation>%1. Medido en %2, en %3 s.</translation>
    </message>
    <message>
        <source>The mechanism has changed since: run again.</source>
        <translation>El mecanismo ha cambiado desde entonces: vuelva a medir.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Every method is timed at the same time steps of one revolution, and its error is measured against a computation with 115 digits.</source>
        <translation>Cada método se cronometra en los mismos pasos de tiempo de una revolución, y su error se mide frente a un cálculo con 115 cifras.</translation>
    </message>
    <message>
        <source>How fast and how accurate is each method for this mechanism?</source>
        <translation>¿Cuán rápido y cuán exacto es cada método para este mecanismo?</translation>
    </message>
</context>
<context>
    <name>slidercrank::StudyText</name>
    <message>
        <source>initial mechanism</source>
        <translation>mecanismo inicial</translation>
    </message>
    <message>
        <source>this mechanism</source>
        <translation>este mecanismo</translation>
    </message>
    <message>
        <source>sample file</source>
        <translation>archivo de muestra</translation>
    </message>
    <message>
        <source>crossed</source>
        <translation>cruzada</translation>
    </message>
    <message>
        <source>toggle gap %1</source>
        <translation>margen %1 hasta la singularidad</translation>
    </message>
    <message>
        <source>exact toggle</source>
        <translation>singularidad exacta</translation>
    </message>
    <message>
        <source>change point</source>
        <translation>punto de cambio</translation>
    </message>
    <message>
        <source>a = b and c = 0</source>
        <translation>a = b y c = 0</translation>
    </message>
    <message>
        <source>rocker</source>
        <translation>oscilante</translation>
    </message>
    <message>
        <source>one arc</source>
        <translation>un arco</translation>
    </message>
    <message>
        <source>two arcs</source>
        <translation>dos arcos</translation>
    </message>
    <message>
        <source>barely a rocker</source>
        <translation>casi vueltas completas</translation>
    </message>
    <message>
        <source>gap %1</source>
        <translation>margen %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>never assemblable</source>
        <translation>no se puede ensamblar</translation>
    </message>
    <message>
        <source>lengths x %1</source>
        <translation>longitudes x %1</translation>
    </message>
    <message>
        <source>t near %1</source>
        <translation>t cerca de %1</translation>
    </message>
    <message>
        <source>%1 steps a turn</source>
        <translation>%1 pasos por revolución</translation>
    </message>
    <message>
        <source>%1 threads</source>
        <translation>%1 hilos</translation>
    </message>
    <message>
        <source>not optimized</source>
        <translation>sin optimizar</translation>
    </message>
    <message>
        <source>The closed form is %1 times as fast as dense Newton-Raphson with its default tolerance (± %2 %).</source>
        <translation>La forma cerrada es %1 veces tan rápida como Newton-Raphson denso con su tolerancia por defecto (± %2 %).</translation>
    </message>
</context>
<context>
    <name>slidercrank::TablePanel</name>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copies the tables as CSV, at full precision</source>
        <translation>Copia las tablas como CSV, con precisión completa</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Writes the tables to a CSV file, at full precision</source>
        <translation>Escribe las tablas en un archivo CSV, con precisión completa</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>The rows are in the clipboard, as CSV with headings.</source>
        <translation>Las filas están en el portapapeles, como CSV con encabezados.</translation>
    </message>
</context>
<context>
    <name>slidercrank::Timeline</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>θ₂</source>
        <translation>θ₂</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Start again at the end (Ctrl+L)</source>
        <translation>Volver a empezar al llegar al final (Control+L)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>Re&amp;producir o pausar</translation>
    </message>
    <message>
        <source>Step &amp;forward</source>
        <translation>Un paso &amp;adelante</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Un paso a&amp;trás</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>Al &amp;inicio</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>Al &amp;final</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>Más rápi&amp;do</translation>
    </message>
    <message>
        <source>Slo&amp;wer</source>
        <translation>Más &amp;lento</translation>
    </message>
    <message>
        <source>&amp;Time range and speed…</source>
        <translation>Intervalo de tie&amp;mpo y velocidad…</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Repetir</translation>
    </message>
    <message>
        <source>Time in seconds</source>
        <translation>Tiempo en segundos</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Time, slider</source>
        <translation>Tiempo, control deslizante</translation>
    </message>
    <message>
        <source>Time range and speed</source>
        <translation>Intervalo de tiempo y velocidad</translation>
    </message>
    <message>
        <source>%1 s · %2× ▾</source>
        <comment>duration, playback speed</comment>
        <translation>%1 s · %2× ▾</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>The first time step</source>
        <translation>El primer instante</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>From the first time step to the last</source>
        <translation>Del primer instante al último</translation>
    </message>
    <message>
        <source>One revolution</source>
        <translation>Una revolución</translation>
    </message>
    <message>
        <source>Sets the duration to one revolution of the crank</source>
        <translation>Fija la duración en una revolución de la manivela</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Number of intervals: the motion is computed at one instant more, both ends included</source>
        <translation>Número de intervalos: el movimiento se calcula en un instante más, con ambos extremos incluidos</translation>
    </message>
    <message>
        <source>Playback speed</source>
        <translation>Velocidad de reproducción</translation>
    </message>
    <message>
        <source>Seconds of the motion in a second of real time</source>
        <translation>Segundos del movimiento en un segundo de tiempo real</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>Crank angle: type one to go to the nearest time at which the crank passes it, or to turn a crank at rest</source>
        <translation>Ángulo de la manivela: escriba uno para ir al instante más próximo en que la manivela pasa por él, o para girar una manivela en reposo</translation>
    </message>
    <message>
        <source>The crank is fast: shows one revolution, which takes four seconds when it is played</source>
        <translation>La manivela es rápida: muestra una revolución, que dura cuatro segundos al reproducirla</translation>
    </message>
    <message>
        <source>The time range is only a part of a revolution: shows one revolution</source>
        <translation>El intervalo de tiempo es solo una parte de una revolución: muestra una revolución</translation>
    </message>
    <message>
        <source>Start, duration, steps, one revolution, and the playback speed (Ctrl+R). A fast crank is slowed to four seconds a revolution.</source>
        <translation>Inicio, duración, pasos, una revolución y la velocidad de reproducción (Control+R). Una manivela rápida se ralentiza a cuatro segundos por revolución.</translation>
    </message>
    <message>
        <source>Crank angle</source>
        <translation>Ángulo de la manivela</translation>
    </message>
    <message>
        <source> rad</source>
        <translation> rad</translation>
    </message>
</context>
<context>
    <name>slidercrank::WholeFileText</name>
    <message>
        <source>it is a pipe or a device</source>
        <translation>es una tubería o un dispositivo</translation>
    </message>
    <message>
        <source>Standard input</source>
        <translation>Entrada estándar</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another name or folder.</source>
        <translation>No se puede escribir %1: %2. Elija otro nombre u otra carpeta.</translation>
    </message>
</context>
<context>
    <name>slidercrank::TypedValueText</name>
    <message>
        <source>exact: %1</source>
        <translation>exacto: %1</translation>
    </message>
    <message>
        <source>“%1” does not show to which digit it is rounded: write it as a decimal number, such as %2.</source>
        <translation>«%1» no muestra en qué cifra está redondeado: escríbalo como número decimal, por ejemplo %2.</translation>
    </message>
</context>
</TS>
