# Draws the last frame of drum.dump: gnuplot rotating_drum.gnuplot writes rotating_drum.png.
set terminal pngcairo size 900,760 font "DejaVu Sans,13"
set output "rotating_drum.png"
set size ratio -1
set xrange [-54:54]
set yrange [-54:54]
set xlabel "x [mm]"
set ylabel "y [mm]"
set cblabel "speed [m/s]"
set cbrange [0:*]
set palette defined (0 "#440154", 0.25 "#3b528b", 0.5 "#21918c", 0.75 "#5ec962", 1 "#fde725")
set title "Rotating drum, 3 rad/s: the fractional law in LIGGGHTS"
set object 1 circle at 0,0 size 50 fillstyle empty border lc rgb "black" lw 2
unset key
set style fill solid 1.0 border lc rgb "gray20"
last = "< awk '/ITEM: TIMESTEP/ { n = 0 } /^[0-9]+ [0-9]+ / && NF >= 9 { row[n++] = $0 } END { for (i = 0; i < n; i++) print row[i] }' drum.dump"
plot last using (1e3*$3):(1e3*$4):(1e3*$9):(sqrt($6**2 + $7**2 + $8**2)) with circles lc palette
